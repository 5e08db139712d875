# Two commands: `make book` builds the book, `make test` runs every check. `make help` lists the rest.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
LAB := jupyterlab==4.6.6# leaves what is locked as it is; no check and no page needs it, so the lock does without
READY := $(VENV)/.ready
export OPENBLAS_NUM_THREADS := 1
export PYTHONDONTWRITEBYTECODE := 1

.PHONY: help book pdf serve lab instructor platforms test test-all quick chapter environment assets parity experiments audit monocular starts measurement-errors real-images real-sequences visual-odometry stereo-slam report-experiments other-filters rosetta generate tangle untangle notebooks format lock clean

help:  ## list the targets
	@grep -hE '^[a-z-]+:.*##' $(MAKEFILE_LIST) | sed 's/:.*## /\t/' | expand -t 20

book: environment  ## build the book (HTML) and print where it is
	@$(BIN)/python -m book.tools.build

pdf: book  ## print the whole book as a PDF, linked from its landing page (needs Chromium; minutes)
	@$(BIN)/python -m book.tools.pdf

serve: book  ## build the book and serve it on this machine only
	@$(BIN)/python -m book.tools.serve

lab: $(VENV)/.lab  ## open the chapters in JupyterLab, with the environment's kernel
	@$(BIN)/jupyter lab book/chapters

$(VENV)/.lab: $(READY)
	@echo "adding JupyterLab to $(VENV) (once)"
	@$(BIN)/python -m pip install --quiet --disable-pip-version-check $(LAB)
	@$(BIN)/python -m pip check --quiet --disable-pip-version-check
	@touch $@

instructor: environment  ## pack the notebooks without their solutions, for those who teach
	@$(BIN)/python -m book.tools.instructor

test: environment  ## run every check of .ci/run, with a summary line each
	@$(BIN)/python -m book.tools.ci

test-all: environment  ## every check, on all pages in the browser; before a release, and every night
	@$(BIN)/python -m book.tools.ci --all

quick: environment  ## while you work: lint, tangled and stored cells, the core's tests (under a minute)
	@$(BIN)/python -m book.tools.ci lint format tangled stored core

chapter: environment  ## run one notebook, compare it with what it stores, and build its page: make chapter NAME=points
	@$(BIN)/python -m book.tools.build $(or $(NAME),$(error make chapter NAME=points))

environment: $(READY)  ## create .venv from requirements.txt (exact, with hashes)

$(READY): requirements.txt
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || \
	  { echo "Python 3.11 or newer is needed, and $(PYTHON) is $$($(PYTHON) --version): try make PYTHON=python3.12"; exit 1; }
	@$(PYTHON) -c 'import ensurepip, venv' 2>/dev/null || \
	  { echo "Python's venv is missing: on Debian and Ubuntu, apt-get install python3-venv"; exit 1; }
	@echo "creating the environment in $(VENV) (once, about a minute)"
	@$(PYTHON) -m venv $(VENV)
	@$(BIN)/python -m pip install --quiet --disable-pip-version-check --require-hashes -r requirements.txt
	@$(BIN)/python -c 'import pathlib, sysconfig; pathlib.Path(sysconfig.get_path("purelib"), "slamlib-source.pth").write_text("$(CURDIR)\n$(CURDIR)/book\n")'
	@touch $@

assets: environment  ## fetch what the site serves itself (MathJax, Python for the page), by version and checksum
	@$(BIN)/python -m book.tools.assets

parity: book  ## compare the page's Python with this one, and store the appendix's table (needs Chromium)
	@$(BIN)/python -m pytest -q book/tests/site -k two_pythons --store-parity

experiments: environment  ## run the Monte Carlo experiments of chapters toolbox_tour and observability (hours; resumable)
	@$(BIN)/python -m book.tools.experiments
	@$(BIN)/python -m book.tools.consistency

audit: environment  ## compute every figure of the errata E01 to E30 of the report again (ARGS=--store, "--only E07", --json)
	@$(BIN)/python -m book.tools.audit $(ARGS)

monocular: environment  ## run the longer films of chapter monocular in the rendered room, and store their figures
	@$(BIN)/python -m book.tools.monocular

starts: environment  ## run the starts of one camera, and the kidnapped ones, on rendered films; store their figures (long)
	@$(BIN)/python -m book.tools.starts

measurement-errors: environment  ## find what errors of a measurement are made of, on rendered films; store figures (long; resumable)
	@$(BIN)/python -m book.tools.measurement_errors

real-images: environment  ## fetch the real sequence of chapter monocular (75 MB), run the filter on it, store its figures
	@$(BIN)/python -m book.tools.real_images

real-sequences: environment  ## run the filter on every public recording below SLAMLIB_DATA, and store its figures (resumable)
	@$(BIN)/python -m book.tools.real_sequences $(ARGS)

visual-odometry: environment  ## run the longer films of chapter visual_odometry, and store their figures
	@$(BIN)/python -m book.tools.visual_odometry

stereo-slam: environment  ## run the longer films of chapter stereo_ekf_slam and the audit's runs, and store their figures (long)
	@$(BIN)/python -m book.tools.stereo_slam

report-experiments: environment  ## run the experiments that the report asks for, and store their figures (page report_experiments)
	@$(BIN)/python -m book.tools.report_experiments

other-filters: environment  ## run the comparison of filters of chapter other_filters, and store its figures (long)
	@$(BIN)/python -m book.tools.other_filters

rosetta: environment  ## write the tables of the page Rosetta from its CSV and the package
	@$(BIN)/python -m book.tools.rosetta

generate: environment  ## write slamlib/generated from the models
	@$(BIN)/python -m slamlib.codegen

tangle: environment  ## write the formula modules from the chapters' cells
	@$(BIN)/python -m book.tools.tangle

untangle: environment  ## carry edited formula modules back into the chapters' cells
	@$(BIN)/python -m book.tools.tangle --back

notebooks: environment  ## run every notebook in place and store its text outputs
	@$(BIN)/python -m book.tools.notebooks run

format: environment  ## format the Python code
	@$(BIN)/ruff format && $(BIN)/ruff check --fix

platforms: environment  ## does the lock install on Linux, macOS and Windows? (needs the network; minutes)
	@$(BIN)/python -m book.tools.platforms

lock: environment  ## make requirements.txt from requirements.in (needs uv)
	uv pip compile requirements.in --universal --python-version 3.11 --generate-hashes --no-header \
	  --no-emit-index-url --no-emit-find-links --output-file requirements.txt

clean:  ## remove what was built (not the environment)
	rm -rf _build .mypy_cache .ruff_cache .pytest_cache .hypothesis
