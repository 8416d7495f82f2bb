#!/usr/bin/python3
"""tools/count_tests.py BUILD: "PASSED FAILED SKIPPED" of the last ctest in the build folder BUILD.

ctest knows a GoogleTest program, or a share of its tests, as one test; here each test counts. A program that ended without
its results counts as one that failed.
"""

import pathlib
import sys
import xml.etree.ElementTree as xml


def counts(case, results):
    """Of one test of ctest: passed, failed, skipped."""
    has_passed = case.get("status") == "run"
    if case.get("status") in ("disabled", "notrun"):
        return 0, 0, 1
    if not results.exists():
        return (1, 0, 0) if has_passed else (0, 1, 0)
    tests = list(xml.parse(results).getroot().iter("testcase"))
    skipped = sum(test.get("result") in ("skipped", "suppressed") for test in tests)
    failed = sum(test.find("failure") is not None for test in tests)
    if not has_passed and failed == 0:
        failed = 1  # it ended after its last test
    return len(tests) - failed - skipped, failed, skipped


def main():
    build = pathlib.Path(sys.argv[1])
    cases = xml.parse(build / "tests.xml").getroot().iter("testcase")
    all_counts = [counts(case, build / "test-results" / f"{case.get('name')}.xml") for case in cases]
    print(*(sum(column) for column in zip(*all_counts)))


if __name__ == "__main__":
    main()
