#!/usr/bin/env python3
"""Fails where a header has a sign that a person would not write there: a + -b, a * (-b), -(-a + b).

    check_signs.py HEADER...
"""

import re
import sys

ODD = re.compile(r"[-+*/] -[\w(]|[*/] \(-[a-zA-Z_]\w*\)|-\(-")


def main():
    found = []
    for header in sys.argv[1:]:
        with open(header, encoding="utf-8") as file:
            for number, line in enumerate(file, 1):
                if ODD.search(line.split("//")[0]):
                    found.append(f"{header}:{number}: {line.strip()}")
    print("\n".join(found[:20]) or "no odd signs")
    sys.exit(1 if found or len(sys.argv) < 2 else 0)


main()
