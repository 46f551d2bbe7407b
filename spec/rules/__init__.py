"""The rules of movement, a chapter each: clearance, push, walk, request."""
