"""Rows of what was measured, and what was left out and why."""

import json
import re


class Results:
    def __init__(self):
        self.rows = []
        self.skipped = []

    def add(self, case, tool, metric, value, unit, **more):
        """`more`: low and high, the tenth and the ninetieth percentile."""
        model, size = case
        self.rows.append({"model": model, "size": size, "tool": tool, "metric": metric, "value": value, "unit": unit, **more})

    def skip(self, what, why):
        last = why.strip().splitlines()[-1] if why.strip() else ""
        # Without the folders of this machine.
        self.skipped.append({"what": what, "why": re.sub(r"(?<![\w.])/\S*/", "", last)[:300]})
        print(f"bench: left out: {what}: {why.strip()[:2000]}", flush=True)


class Document:
    """latest.json as the report reads it."""

    def __init__(self, document):
        self.date = document["date"]
        self.selection = document["selection"]
        self.machine = document["machine"]
        self.skipped = document["skipped"]
        self.rows = document["rows"]
        self.values = {(row["model"], row["size"], row["tool"], row["metric"]): row for row in self.rows}

    def value(self, model, size, tool, metric):
        row = self.values.get((model, size, tool, metric))
        return row["value"] if row else None

    def tools(self, model, metric):
        """In the order of their first appearance."""
        return list(dict.fromkeys(row["tool"] for row in self.rows if row["model"] == model and row["metric"] == metric))

    def sizes(self, model, metric):
        return sorted({row["size"] for row in self.rows if row["model"] == model and row["metric"] == metric})

    def best(self, model, size, metric, prefix):
        """The least of the tools whose names begin so: of several ways, each size has its best."""
        found = [row["value"] for row in self.rows
                 if (row["model"], row["size"], row["metric"]) == (model, size, metric) and row["tool"].startswith(prefix)]
        return min(found) if found else None


def write(path, results, machine, date, selection):
    rows = ",\n".join("    " + json.dumps(row) for row in results.rows)
    skipped = ",\n".join("    " + json.dumps(row) for row in results.skipped)
    head = json.dumps({"date": date, "selection": selection, "machine": machine}, indent=2)
    path.parent.mkdir(parents=True, exist_ok=True)
    # A row in each line, so that a difference can be read.
    path.write_text(f'{head[:-2]},\n  "skipped": [\n{skipped}\n  ],\n  "rows": [\n{rows}\n  ]\n}}\n'.replace("[\n\n", "[\n"),
                    encoding="utf-8")


def merged(old, new):
    """The old document with what was measured anew: the rows of all cases that are in the new one. It says so."""
    def cases(document):
        return {(row["model"], row["size"]) for row in document["rows"]}
    kept = Results()
    again = cases(new)
    kept.rows = [row for row in old["rows"] if (row["model"], row["size"]) not in again] + new["rows"]
    kept.skipped = [entry for entry in old["skipped"] if entry not in new["skipped"]
                    and not any(entry["what"].startswith(f"{model}_{size}:") for model, size in again)] + new["skipped"]
    selection = f"{old['selection']}; anew at {new['machine']['commit']}, {new['date']}: {new['selection']}"
    return kept, old["machine"], old["date"], selection


def read(path):
    return Document(json.loads(path.read_text(encoding="utf-8")))


ROW_KEYS = {"model": str, "size": int, "tool": str, "metric": str, "value": (int, float), "unit": str}


def faults(document):
    """What is not as it should be in the shape of the file; empty when all is."""
    found = [f"no '{key}'" for key in ("date", "selection", "machine", "skipped", "rows") if key not in document]
    for row in document.get("rows", []):
        found += [f"{row}: '{key}'" for key, kind in ROW_KEYS.items() if not isinstance(row.get(key), kind)]
    names = [(row["model"], row["size"], row["tool"], row["metric"]) for row in document.get("rows", []) if not found]
    found += [f"twice: {name}" for name in sorted({name for name in names if names.count(name) > 1})]
    return found
