#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Validates configs against the JSON Schema of the format, as editors do.

usage: schema_check.py SCHEMA CONFIG...

A line per config: "valid NAME", "invalid NAME: PLACE: FAULT", or "no YAML NAME". Every config is
read twice, as YAML 1.1 (PyYAML as it is: y and on are truth values, 1e-5 is a text) and as YAML
1.2; where the verdicts differ the line begins with "disagree". Exit 77: no jsonschema or PyYAML.
"""
import os
import re
import sys

try:
    import jsonschema
    import yaml
except ImportError as error:
    print(error)
    sys.exit(77)


class Core(yaml.SafeLoader):
    """The core schema of YAML 1.2: true and false only, numbers as JSON has them."""


Core.yaml_implicit_resolvers = {}
for tag, pattern, first in [
    ("bool", r"^(true|false)$", "tf"),
    ("null", r"^(null|~|)$", ["n", "~", ""]),
    ("int", r"^[-+]?[0-9]+$", "-+0123456789"),
    ("float", r"^[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?$", "-+.0123456789"),
]:
    Core.add_implicit_resolver("tag:yaml.org,2002:" + tag, re.compile(pattern), list(first))


def plain(value):
    """Keys as texts, as JSON has them."""
    if isinstance(value, dict):
        return {str(key): plain(item) for key, item in value.items()}
    if isinstance(value, list):
        return [plain(item) for item in value]
    return value


def verdict(validator, text, loader):
    try:
        tree = plain(yaml.load(text, loader))
    except (yaml.YAMLError, ValueError, RecursionError) as error:
        return "no YAML", str(error).split("\n")[0]
    fault = jsonschema.exceptions.best_match(validator.iter_errors(tree))
    if fault is None:
        return "valid", ""
    return "invalid", "/".join(map(str, fault.path)) + ": " + fault.message[:160]


def main(schema_path, configs):
    with open(schema_path, encoding="utf-8") as file:
        schema = yaml.safe_load(file)
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    for path in configs:
        with open(path, encoding="utf-8", errors="replace") as file:
            text = file.read()
        old, fault = verdict(validator, text, yaml.SafeLoader)
        new, _ = verdict(validator, text, Core)
        told = old if old == new else "disagree " + old + " " + new
        print(told, os.path.basename(path) + (": " + fault if fault else ""))


main(sys.argv[1], sys.argv[2:])
