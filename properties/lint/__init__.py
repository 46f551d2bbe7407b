"""Linting levels: which guideline or condition fails where, what goes wrong there, and what would mend it."""
