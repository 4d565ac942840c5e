# Two commands matter: make demo, make test. Both need python3 alone and build .venv themselves.

PYTHON ?= python3
VENV   := .venv
BIN    := $(VENV)/bin
DEMO   := demo.out
export PIP_DISABLE_PIP_VERSION_CHECK := 1
# empty, whatever it is outside: without kept bytecode each process of the tests would compile all modules anew
export PYTHONDONTWRITEBYTECODE :=
WEB    := $(VENV)/web
PYTEST := $(BIN)/python -m pytest -n 2 --dist worksteal

.PHONY: demo test slow estimates lint bench accuracy accuracy-draw pictures docs format schema clean

demo: $(VENV)/.run
	@mkdir -p $(DEMO)
	$(BIN)/tmmcalc run configs/course-project.toml --plots -o $(DEMO) > $(DEMO)/summary.txt
	@echo
	$(BIN)/tmmcalc flywheel configs/course-project.toml -o $(DEMO) --quiet
	@echo
	@echo "The press in its positions:  $(DEMO)/kinematics.svg"
	@echo "The other pictures, tables:  $(DEMO)/, what was found: $(DEMO)/summary.txt"
	@echo "The spec of all of it:       configs/course-project.toml"
	@echo "A project of your own:       $(BIN)/tmmcalc init shaper -o my.toml"
	@echo "                             $(BIN)/tmmcalc run my.toml --plots"

test: $(VENV)/.dev
	$(PYTEST) -m "not slow"

slow: $(VENV)/.dev
	$(PYTEST) -m slow

# every estimate of an error against the truth over all its random scenes, of which `make slow` takes a part: an hour
estimates: $(VENV)/.dev
	ESTIMATES=1 $(PYTEST) -m slow -k "estimate or bound or sizes or frequencies"

lint: $(VENV)/.dev $(WEB)/.ready
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/node $(WEB)/node_modules/@biomejs/biome/bin/biome lint --config-path=.ci/web --error-on-warnings tmmcalc/page/web/*.js
	$(BIN)/node $(WEB)/node_modules/typescript/bin/tsc --project .ci/web

bench: $(VENV)/.dev
	$(BIN)/python tests/bench.py

# docs/accuracy.md with its diagrams: errors and times of all methods, measured on this machine
accuracy: $(VENV)/.dev
	$(BIN)/python docs/make_accuracy.py

# the same drawn from what was measured last
accuracy-draw: $(VENV)/.run
	$(BIN)/python docs/make_accuracy.py --draw

# the pictures of the README and the guide
pictures: $(VENV)/.dev
	$(BIN)/python docs/make_pictures.py

format: $(VENV)/.dev
	$(BIN)/ruff check --fix --quiet .
	$(BIN)/ruff format .

# the tables of keys and the laws of cams in docs/spec.md, docs/results.md from the fields of results
docs: $(VENV)/.run
	$(BIN)/python docs/make_spec.py
	$(BIN)/python docs/make_results.py

# the schema that editors follow from the #:schema line of the ready specs
schema: $(VENV)/.run
	$(BIN)/tmmcalc schema -o configs/tmmcalc.schema.json

$(VENV)/.run: pyproject.toml | $(BIN)/python
	$(BIN)/python -m pip install --quiet --editable '.[plot]'
	$(BIN)/python -m compileall -q tmmcalc
	@touch $@

$(VENV)/.dev: pyproject.toml | $(BIN)/python
	$(BIN)/python -m pip install --quiet --editable '.[dev]'
	$(BIN)/python -m compileall -q tmmcalc
	@touch $@ $(VENV)/.run

# what the scripts of the page are checked with, by the npm that dev brings
$(WEB)/.ready: .ci/web/package.json .ci/web/package-lock.json | $(VENV)/.dev
	@mkdir -p $(WEB)
	@cp .ci/web/package.json .ci/web/package-lock.json $(WEB)
	$(BIN)/npm ci --prefix $(WEB) --ignore-scripts --no-audit --no-fund --silent
	@touch $@

$(BIN)/python:
	$(PYTHON) -m venv $(VENV)

clean:
	rm -rf $(VENV) $(DEMO) build dist .pytest_cache .hypothesis .mypy_cache .ruff_cache
