# One target per habitual action; `make` alone lists them.

PYTHON ?= python3
VENV   := .venv
BIN    := $(VENV)/bin
PIP    := $(BIN)/python -m pip --quiet --disable-pip-version-check
PINNED := $(VENV)/.pinned
READY  := $(VENV)/.ready
COMPARED := $(VENV)/.compared
SMTLIB := build/smtlib
BROKEN := build/smtlib-mutants
SCENARIOS ?= 100000
LEVELS ?= 10500
SOURCE := $(shell find spec reference properties -name '*.py')

.DEFAULT_GOAL := help
.DELETE_ON_ERROR:

.PHONY: help
help: ## list the targets
	@awk -F ':.*## ' '/^[a-z.-]+:.*## / { printf "  make %-16s %s\n", $$1, $$2 }' $(firstword $(MAKEFILE_LIST))

# The packages exactly as pinned: made from nothing whenever the pins change.
$(PINNED): requirements.txt
	@echo "setting up $(VENV) with $$($(PYTHON) --version)"
	@$(PYTHON) -m venv --clear $(VENV)
	@$(PIP) install --require-hashes -r requirements.txt
	@touch $@

# The project itself, editable; its build backend is one of the pinned packages.
$(READY): $(PINNED) pyproject.toml
	@$(PIP) install --no-deps --no-build-isolation --editable .
	@touch $@

.PHONY: $(VENV)
$(VENV): $(READY) ## set up the virtual environment (the targets that need it do so themselves)
	@:

.PHONY: check
check: $(READY) ## check the specification: every property against every rule and the reference
	@$(BIN)/graphbody check
	@$(BIN)/graphbody map --check

.PHONY: check-long
check-long: $(READY) ## check the claims that take long: the hunts for witnesses on small levels
	@$(BIN)/graphbody check --long

.PHONY: ledger
ledger: $(READY) ## print what every verdict rests on, with the spread of the solver's work over its seeds
	@$(BIN)/graphbody check --explain

.PHONY: test
test: $(READY) ## run the tests, but for the slow ones
	@$(BIN)/pytest -n 2 --dist worksteal -m 'not slow'

.PHONY: test-long
test-long: $(READY) ## run the slow tests
	@$(BIN)/pytest -n 2 --dist worksteal -m slow

.PHONY: independent
independent: $(READY) ## compare the reference with a second program, on LEVELS random levels, 10,500 if not said
	@PYTHONPATH=tests $(BIN)/python -m independent $(LEVELS)

# Seconds are those of the processor: what else runs on the machine counts for less.
.PHONY: bench
bench: $(COMPARED) ## time the proofs, beside CrossHair, and the steps, beside Box2D; write docs/benchmarks.md
	@mkdir -p build
	@$(BIN)/pytest tests/benchmarks -o python_files='bench_*.py' -p no:xdist --benchmark-only --benchmark-quiet \
		--benchmark-timer=time.process_time --benchmark-json=build/bench.json
	@PYTHONPATH=tests $(BIN)/python -m benchmarks.page build/bench.json docs/benchmarks.md

# What the evaluation needs besides, in the versions that fit the other pins.
$(COMPARED): requirements-evaluation.txt $(READY)
	@$(PIP) install --require-hashes -r requirements-evaluation.txt
	@touch $@

.PHONY: evaluation
evaluation: $(COMPARED) ## run the evaluation of the thesis anew, beside Box2D; write docs/evaluation.md with its data
	@PYTHONPATH=tests $(BIN)/python -m evaluation

.PHONY: evaluation-check
evaluation-check: $(COMPARED) ## run it again, but for the times, and fail if that differs from docs/evaluation.md
	@PYTHONPATH=tests $(BIN)/python -m evaluation check

.PHONY: mutants
mutants: $(READY) ## show that wrong rules, contracts, invariants and engines are caught, as docs/mutants.md says
	@rm -rf $(BROKEN)
	@$(BIN)/graphbody mutants --export $(BROKEN)

.PHONY: mutants-record
mutants-record: $(READY) ## find anew what catches each mutant, and write docs/mutants.md and docs/mutants
	@$(BIN)/graphbody mutants --record

# What was exported stands for the sources it was made from. An export is made anew, never added to.
$(SMTLIB)/obligations.json: $(READY) $(SOURCE)
	@rm -rf $(SMTLIB)
	@$(BIN)/graphbody check --export $(SMTLIB)

$(BROKEN)/obligations.json: $(READY) $(SOURCE)
	@$(MAKE) --no-print-directory mutants

.PHONY: compare
compare: $(READY) ## compare the profiles repaired and thesis over SCENARIOS scenarios, 100,000 if not said
	@$(BIN)/graphbody compare --scenarios $(SCENARIOS)

.PHONY: map
map: $(READY) ## find out which levels are safe under which rules, and write docs/map.md
	@$(BIN)/graphbody map

.PHONY: cross-check
cross-check: $(SMTLIB)/obligations.json $(BROKEN)/obligations.json ## have a second solver decide what Z3 has decided
	@$(BIN)/graphbody cross-check $(SMTLIB) $(BROKEN)

.PHONY: docs
docs: $(READY) ## write the reference and the tables of formats anew, from the last check and check-long
	@$(BIN)/graphbody handbook docs

.PHONY: docs-check
docs-check: docs ## fail if that has changed anything
	@git diff --stat --exit-code -- docs
	@test -z "$$(git status --porcelain -- docs)" || { git status --short -- docs; exit 1; }

.PHONY: lint
lint: $(READY) ## check style, formatting, types and the layering of the packages
	@$(BIN)/ruff check .
	@$(BIN)/ruff format --check .
	@$(BIN)/mypy
	@$(BIN)/lint-imports --no-logo

.PHONY: format
format: $(READY) ## format the code and sort the imports
	@$(BIN)/ruff check --fix-only .
	@$(BIN)/ruff format .

# uv resolves once for every supported Python and platform. It lives in a throw-away environment,
# because nothing but this target needs it.
.PHONY: pins
pins: ## resolve the pins anew, to the newest versions that pyproject.toml allows
	@$(PYTHON) -m venv build/pins
	@build/pins/bin/python -m pip --quiet --disable-pip-version-check install --upgrade uv
	@build/pins/bin/uv pip compile --quiet --upgrade --universal --python-version 3.11 \
		--fork-strategy fewest --generate-hashes --extra dev \
		--custom-compile-command 'make pins' --output-file requirements.txt pyproject.toml
	@build/pins/bin/uv pip compile --quiet --upgrade --universal --python-version 3.11 \
		--fork-strategy fewest --generate-hashes --extra evaluation --constraints requirements.txt \
		--custom-compile-command 'make pins' --output-file requirements-evaluation.txt pyproject.toml

.PHONY: clean
clean: ## remove everything that can be made again
	@rm -rf $(VENV) build dist .pytest_cache .mypy_cache .ruff_cache .import_linter_cache .hypothesis
	@find . -name __pycache__ -type d -prune -exec rm -rf {} +
