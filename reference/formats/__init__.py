"""The files: levels, scenarios and traces, in JSON, with exact numbers and errors that name the place."""
