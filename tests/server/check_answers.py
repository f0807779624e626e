"""Prints what is wrong with answers by their schemas, a line each: check_answers.py FILE, whose lines are JSON objects
with name, schema and value."""

import json
import sys

from jsonschema import Draft202012Validator

checked = 0
with open(sys.argv[1], encoding="utf-8") as file:
    for line in file:
        one = json.loads(line)
        Draft202012Validator.check_schema(one["schema"])
        checked += 1
        for error in list(Draft202012Validator(one["schema"]).iter_errors(one["value"]))[:5]:
            where = "/".join(str(part) for part in error.absolute_path)
            print(f"{one['name']}: {where}: {error.message[:300]}")
if checked == 0:
    print("nothing to check")
