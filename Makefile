# Lanewright: `make run` starts it, `make test` proves it, `make help` lists the rest.
SHELL := /bin/bash
.SHELLFLAGS := -euo pipefail -c
.DEFAULT_GOAL := help
.PHONY: help install install-test run stop test test-python test-frontend check check-python check-frontend types format bench chaos demo clean
MAKEFLAGS += --no-print-directory
# Where the environment forbids Python to keep compiled modules, each start would take twice as long.
export PYTHONDONTWRITEBYTECODE :=

bin := .venv/bin

help: ## List what make can do
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "  make %-16s %s\n", $$1, $$2 }' $(MAKEFILE_LIST)

install: ## Install what running needs, and build the frontend
	@scripts/debian_packages.sh run
	@scripts/python_packages.sh run
	@scripts/frontend.sh build

install-test:
	@scripts/debian_packages.sh test
	@scripts/python_packages.sh test
	@scripts/frontend.sh build

run: install ## Start Lanewright on http://127.0.0.1:8000 (installs what is missing; Ctrl-C stops it)
	@exec $(bin)/lanewright serve

stop: ## Stop what `make run` started
	@if [ -x $(bin)/lanewright ]; then $(bin)/lanewright stop; else echo 'Lanewright is not installed, so it does not run.'; fi

test: test-python test-frontend ## Run everything that proves the product, browser tests included

test-python: install-test ## Run the Python and browser tests (PYTEST_ARGS="-k words" picks some)
	@$(bin)/pytest $(PYTEST_ARGS)

test-frontend: install-test ## Run the frontend's unit tests
	@scripts/frontend.sh test

check: check-python check-frontend ## Formatters, linters, types, import contracts, conventions, generated files

check-python: install-test
	@$(bin)/ruff format --check .
	@$(bin)/ruff check .
	@$(bin)/mypy
	@$(bin)/lint-imports
	@$(bin)/pytest -q tests/repo

check-frontend: install-test
	@scripts/frontend.sh check

types: ## Regenerate the OpenAPI description and the frontend's types from it
	@scripts/python_packages.sh test
	@$(bin)/lanewright openapi >frontend/openapi.json.new && mv frontend/openapi.json.new frontend/openapi.json
	@scripts/frontend.sh types

format: install-test ## Format all sources, and mend what linters can mend
	@$(bin)/ruff check --fix-only .
	@$(bin)/ruff format .
	@scripts/frontend.sh format

chaos: install-test ## Twenty tabs save while server and database are killed with -9, twenty times
	@LANEWRIGHT_CHAOS_KILLS=20 $(bin)/pytest -q -s tests/chaos

bench: install-test ## Measure opening a task and saving against the bare database
	@$(bin)/python -m bench

demo: install ## Generate demo logs into ./demo-logs (FOLDER=… elsewhere)
	@$(bin)/lanewright demo $(or $(FOLDER),demo-logs)

clean: stop ## Remove everything installed and built; the data in .lanewright stays
	@rm -rf .venv .venv.lock frontend/node_modules frontend/dist .pytest_cache .mypy_cache .ruff_cache .hypothesis
