"""Prints what is wrong with a JSON file by a JSON Schema, a line each: validate.py SCHEMA FILE. Of a file .jsonl each
line is an object."""

import json
import sys

from jsonschema import Draft202012Validator

schema_file, data_file = sys.argv[1:]
with open(schema_file, encoding="utf-8") as file:
    schema = json.load(file)
Draft202012Validator.check_schema(schema)
validator = Draft202012Validator(schema)
with open(data_file, encoding="utf-8") as file:
    documents = [json.loads(line) for line in file] if data_file.endswith(".jsonl") else [json.load(file)]
if not documents:
    print("no document")
told = set()
for document in documents:
    for error in validator.iter_errors(document):
        where = "/".join("*" if isinstance(part, int) else part for part in error.absolute_path)
        if (where, error.message[:60]) not in told:
            told.add((where, error.message[:60]))
            print(f"{where}: {error.message[:300]}")
