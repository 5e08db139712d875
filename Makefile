# Two commands: `make book` builds the book, `make test` runs every check. `make help` lists the rest.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
READY := $(VENV)/.ready
COMMAND := $(VENV)/.command
OLDEST := _build/oldest
NUMPY ?= 1.25.*
REVIEW := _build/review
export OPENBLAS_NUM_THREADS := 1

.PHONY: help book pdf serve lab instructor platforms test test-all quick oldest mutants review chapter environment assets parity experiments audit monocular starts conversion measurement-errors real-images real-sequences visual-odometry stereo-slam report-experiments other-filters absolute-measurements error-coordinates plane-filters invariant-nees presets-by-both-errors predictions many-maps rosetta generate tangle untangle notebooks format lock clean

help:  ## list the targets
	@grep -hE '^[a-z-]+:.*##' $(MAKEFILE_LIST) | sed 's/:.*## /\t/' | expand -t 20

book: environment  ## build the book (HTML) and print where it is
	@$(BIN)/python -m book.tools.build

pdf: book  ## print the whole book as a PDF, linked from its landing page (needs Chromium; minutes)
	@$(BIN)/python -m book.tools.pdf

serve: book  ## build the book and serve it on this machine only
	@$(BIN)/python -m book.tools.serve

lab: environment  ## open the chapters in JupyterLab, with the environment's kernel
	@$(BIN)/jupyter lab book/chapters

instructor: environment  ## pack the notebooks without their solutions, for those who teach
	@$(BIN)/python -m book.tools.instructor

test: environment  ## run every check of .ci/run, with a summary line each
	@$(BIN)/python -m book.tools.ci

test-all: environment  ## every check, on all pages in the browser; before a release, and every night
	@$(BIN)/python -m book.tools.ci --all

quick: environment  ## while you work: lint, tangled and stored cells, the core's tests (under a minute)
	@$(BIN)/python -m book.tools.ci lint format tangled stored core

mutants: environment  ## change signs and the like in the core's modules: does a test of that very module see it? (long)
	@$(BIN)/python -m book.tools.mutants $(ARGS)

oldest:  ## the core's tests on the wheel and NumPy 1.25, outside the lock (others: make oldest PYTHON=python3.14 NUMPY='2.*')
	@$(PYTHON) -m venv --clear $(OLDEST)
	@$(OLDEST)/bin/python -m pip install --quiet --disable-pip-version-check 'numpy==$(NUMPY)' 'setuptools>=77' pyyaml
	@$(OLDEST)/bin/python -m book.tools.oldest

review:  ## judge packaging and workflows by what the field has agreed on (sp-repo-review, zizmor), outside the lock
	@$(PYTHON) -m venv --clear $(REVIEW)
	@$(REVIEW)/bin/python -m pip install --quiet --disable-pip-version-check 'sp-repo-review[cli]==2026.8.14' zizmor==1.32.0
	@$(REVIEW)/bin/repo-review .
	@$(REVIEW)/bin/zizmor --offline --quiet .github

chapter: environment  ## run one notebook, compare it with what it stores, and build its page: make chapter NAME=points
	@$(BIN)/python -m book.tools.build $(or $(NAME),$(error make chapter NAME=points))

environment: $(COMMAND)  ## create .venv from requirements.txt (exact, with hashes), with the command slamlib

$(READY): requirements.txt
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || \
	  { echo "Python 3.11 or newer is needed, and $(PYTHON) is $$($(PYTHON) --version): try make PYTHON=python3.12"; exit 1; }
	@$(PYTHON) -c 'import ensurepip, venv' 2>/dev/null || \
	  { echo "Python's venv is missing: on Debian and Ubuntu, apt-get install python3-venv"; exit 1; }
	@echo "creating the environment in $(VENV) (once, about a minute)"
	@$(PYTHON) -m venv --clear $(VENV)
	@$(BIN)/python -m pip install --quiet --disable-pip-version-check --require-hashes -r requirements.txt
	@touch $@

# The command and the package's metadata; what is imported are the sources, by two paths that mypy and editors read, too.
$(COMMAND): $(READY) pyproject.toml
	@$(BIN)/python -m pip install --quiet --disable-pip-version-check --no-deps --no-build-isolation --editable .
	@$(BIN)/python -c 'import pathlib, sysconfig; pathlib.Path(sysconfig.get_path("purelib"), "slamlib-source.pth").write_text("$(CURDIR)\n$(CURDIR)/book\n")'
	@$(BIN)/python -m pip check --quiet --disable-pip-version-check
	@touch $@

assets: environment  ## fetch what the site serves itself (MathJax, Python for the page), by version and checksum
	@$(BIN)/python -m book.tools.assets

parity: book  ## compare the page's Python with this one, and store the appendix's table (needs Chromium)
	@$(BIN)/python -m pytest -q book/tests/site -k two_pythons --store-parity

experiments: environment  ## run the Monte Carlo experiments of chapters toolbox_tour and observability (hours; resumable)
	@$(BIN)/python -m book.experiments.toolbox_tour
	@$(BIN)/python -m book.experiments.consistency

audit: environment  ## compute every figure of the errata E01 to E30 of the report again (ARGS=--store, "--only E07", --json)
	@$(BIN)/python -m book.experiments.audit $(ARGS)

monocular: environment  ## run the longer films of chapter monocular in the rendered room, and store their figures
	@$(BIN)/python -m book.experiments.monocular

starts: environment  ## run the starts of one camera, and the kidnapped ones, on rendered films; store their figures (long)
	@$(BIN)/python -m book.experiments.starts

conversion: environment  ## run presets, films and recordings with points converted to Euclidean ones, and not (long; resumable)
	@$(BIN)/python -m book.experiments.conversion

measurement-errors: environment  ## find what errors of a measurement are made of, on rendered films; store figures (long; resumable)
	@$(BIN)/python -m book.experiments.measurement_errors

real-images: environment  ## fetch the real sequence of chapter monocular (75 MB), run the filter on it, store its figures
	@$(BIN)/python -m book.experiments.real_images

real-sequences: environment  ## run the filter on every public recording below SLAMLIB_DATA, and store its figures (resumable)
	@$(BIN)/python -m book.experiments.real_sequences $(ARGS)

visual-odometry: environment  ## run the longer films of chapter visual_odometry, and store their figures
	@$(BIN)/python -m book.experiments.visual_odometry

stereo-slam: environment  ## run the longer films of chapter stereo_ekf_slam and the audit's runs, and store their figures (long)
	@$(BIN)/python -m book.experiments.stereo_slam

report-experiments: environment  ## run the experiments that the report asks for, and store their figures (page report_experiments)
	@$(BIN)/python -m book.experiments.report_experiments

absolute-measurements: environment  ## run GPS beside landmarks by filters that differ in what it does, for chapter observability
	@$(BIN)/python -m book.experiments.absolute_measurements

invariant-nees: environment  ## run starts whose orientation is vague, judged by both errors, for chapter observability
	@$(BIN)/python -m book.experiments.invariant_nees

presets-by-both-errors: environment  ## judge the runs of `make experiments` by the invariant error, too (resumable; ARGS="--runs 100")
	@$(BIN)/python -m book.experiments.presets_by_both_errors $(ARGS)

other-filters: environment  ## run the comparison of filters of chapter other_filters, and store its figures (long)
	@$(BIN)/python -m book.experiments.other_filters

error-coordinates: environment  ## run the right-invariant EKF beside other filters, and store their figures (long; resumable)
	@$(BIN)/python -m book.experiments.error_coordinates

plane-filters: environment  ## run the filters from scratch of chapter ekf_slam, and all data at once, on 400 runs
	@$(BIN)/python -m book.experiments.plane_filters

predictions: environment  ## run what chapter many says of predictions by reported steps, and store its figures (resumable)
	@$(BIN)/python -m book.experiments.predictions

many-maps: environment  ## run one map and many beside each other, for chapter many, and store their figures (resumable)
	@$(BIN)/python -m book.experiments.many_maps

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

lock:  ## make requirements.txt from the extra dev of pyproject.toml (needs uv; ARGS=--upgrade renews all versions)
	uv pip compile pyproject.toml --extra dev --universal --python-version 3.11 --generate-hashes --no-header \
	  --no-emit-index-url --no-emit-find-links --output-file requirements.txt $(ARGS)

clean:  ## remove what was built (not the environment)
	rm -rf _build .mypy_cache .ruff_cache .pytest_cache .hypothesis
