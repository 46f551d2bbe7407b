"""What the thesis evaluates, measured anew beside Box2D; `make evaluation` runs it and writes docs/evaluation.md."""
