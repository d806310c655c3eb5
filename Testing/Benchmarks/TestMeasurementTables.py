# SPDX-License-Identifier: BSD-3-Clause
"""TestMeasurementTables.py GENERATOR: checks pages that make_measurements.py generates from synthetic
measurements and templates."""

import json
import sys
import tempfile
import unittest
from pathlib import Path

GENERATOR = Path(sys.argv.pop(1))
sys.path.insert(0, str(GENERATOR))

from make_measurements import main  # noqa: E402
from cells import seconds, short  # noqa: E402

CLAIMS = [{"text": "is fast", "met": True, "cases": [{"case": "wavelet-97", "number": 5, "met": True}]},
          {"text": "is faster", "met": False, "cases": [{"case": "wavelet-97", "number": 5, "met": True},
                                                        {"case": "disk-out", "number": 0.5, "met": False}]}]


def interval_row(case, peer, own_seconds, peer_seconds, runs=5):
    return {"suite": "interval", "case": case, "method": "interval-volume", "parameter": "1 thread",
            "seconds": own_seconds, "runs": runs, "peer": peer, "peer_seconds": peer_seconds, "peer_runs": runs,
            "ratio": peer_seconds / own_seconds, "counts": {"cells": 8, "tetrahedra": 1234}}


class Project:
    """A temporary project with a README.md and a page template of one table each."""

    def __init__(self, page="{{table interval}}\n", readme="{{readme}}\n"):
        self.temporary = tempfile.TemporaryDirectory()
        self.root = Path(self.temporary.name)
        self.data = self.root / "Documentation" / "measurements"
        self.data.mkdir(parents=True)
        (self.data / "page.in.md").write_text(page, encoding="utf-8")
        (self.data / "readme.in.md").write_text(readme, encoding="utf-8")
        (self.root / "Documentation" / "measurements.md").write_text("", encoding="utf-8")
        guide = self.root / "Documentation" / "guide"
        guide.mkdir(exist_ok=True)
        (guide / "performance.md").write_text("<!-- ratios -->\nold\n<!-- /ratios -->\n", encoding="utf-8")
        (self.root / "README.md").write_text("A\n<!-- measured: x -->\nold\n<!-- /measured -->\nB\n", encoding="utf-8")

    def add(self, rows, version="9.1.0", suite="interval", claims=(), **conditions):
        folder = self.data / ("vtk-" + version[:3])
        folder.mkdir(exist_ok=True)
        results = {"vtk": version, "rows": rows, "suites": {suite: {"took": 12, "claims": list(claims)}},
                   "machine": {"cpu": "one", "cores": 2, "memory_gib": 3.5, "smp": "TBB", "compiler": "gcc 12",
                               "build": "Release"},
                   "conditions": {"date": "2026-01-02", "size": "quick", "threads": 2, "load": 0.25, **conditions}}
        (folder / f"{suite}.json").write_text(json.dumps(results), encoding="utf-8")

    def run(self, *arguments):
        sys.argv = ["make_measurements.py", "--folder", str(self.root), *arguments]
        return main()

    def page(self):
        self.run()
        return (self.root / "Documentation" / "measurements.md").read_text(encoding="utf-8")

    def readme(self):
        self.run()
        return (self.root / "README.md").read_text(encoding="utf-8")


SLOW = [interval_row("disk-out", "clip2", 2.0, 1.0), interval_row("disk-out", "clip2-tetrahedra", 2.0, 8.0)]
FAST = [interval_row("wavelet-97", "clip2", 1.0, 5.0), interval_row("wavelet-97", "clip2-tetrahedra", 1.0, 100.0)]
MISSED = "{{missed interval: is faster}} The limit."


class TestPages(unittest.TestCase):
    def test_numbers(self):
        folder = Project()
        folder.add(FAST + SLOW)
        self.assertIn("| wavelet-97 | 1,234 | 5 | 100 | – |", folder.page())

    def test_the_first_vtk_with_rows_has_the_table(self):
        folder = Project()
        folder.add([dict(row, method="other") for row in SLOW])
        folder.add(FAST, version="9.6.2")
        self.assertIn("| wavelet-97 |", folder.page())
        folder.add(SLOW)
        self.assertNotIn("| wavelet-97 |", folder.page())

    def test_conditions(self):
        folder = Project(page="{{machines}}\n\n{{runs}}\n")
        folder.add(FAST)
        page = folder.page()
        self.assertIn("one, 2 cores, 3.5 GiB, TBB, gcc 12 Release (VTK 9.1)", page)
        self.assertIn("| `interval --quick` | [2026-01-02](measurements/vtk-9.1/interval.json), 0.25 |", page)
        folder.add(FAST, threads=3)
        self.assertIn("| `interval --quick --threads 3` |", folder.page())

    def test_one_run_is_no_median(self):
        folder = Project()
        folder.add([interval_row("wavelet-97", "clip2", 1.0, 5.0, runs=1)])
        self.assertIn("| 5* |", folder.page())

    def test_the_parts_of_a_run_have_loads(self):
        folder = Project(page="{{runs}}\n")
        folder.add(FAST, command="a; b", parts=[{"command": "a", "date": "2026-01-02", "load": 0.5},
                                                {"command": "b", "date": "2026-01-04", "load": 1.5}])
        self.assertIn("| `a …` | [2026-01-02](measurements/vtk-9.1/interval.json), 0.5 to 1.5 |", folder.page())

    def test_losses_first_and_a_column_for_each_vtk(self):
        folder = Project()
        folder.add(FAST + SLOW)
        folder.add(FAST, version="9.6.2")
        readme = folder.readme()
        self.assertIn("| ratio, VTK 9.1 | ratio, VTK 9.6 |", readme)
        guide = (folder.root / "Documentation" / "guide" / "performance.md").read_text(encoding="utf-8")
        self.assertIn("| image 97³ / disk | `vtkTableBasedClipDataSet` twice | 5 / **0.5** | – |", readme)
        self.assertLess(guide.index("disk"), guide.index("wavelet"))
        self.assertIn("| **0.5** / 4 | – |", guide)
        self.assertIn("| 5 / 100 | 5 / 100 |", guide)
        self.assertTrue(readme.startswith("A\n") and readme.endswith("\nB\n"))

    def test_targets(self):
        folder = Project(page=f"{{{{targets interval}}}}\n\n- {MISSED}\n")
        folder.add(FAST, claims=CLAIMS)
        page = folder.page()
        self.assertIn("Targets met: 1/2.", page)
        self.assertIn("- *is faster*: disk-out 0.5. The limit.", page)
        folder.add(FAST, claims=CLAIMS[:1])
        self.assertIn("- *is faster*: not missed. The limit.", folder.page())

    def test_missed_targets_need_their_limits(self):
        folder = Project(page="{{targets interval}}\n")
        folder.add(FAST, claims=CLAIMS)
        with self.assertRaisesRegex(ValueError, "The page lacks {{missed interval: is faster}} and the reason"):
            folder.run()

    def test_targets_are_of_the_first_vtk_with_cases(self):
        folder = Project(page="{{targets interval}}\n")
        folder.add(FAST, claims=[dict(CLAIMS[1], cases=[])])
        folder.add(FAST, version="9.6.2", claims=[dict(CLAIMS[0], text="is faster")])
        self.assertIn("Targets met: 1/1.", folder.page())

    def test_values(self):
        folder = Project(page="It is {{value interval.memory}}.\n")
        folder.add([{"suite": "interval", "case": case, "method": "memory", "counts": {"peak_share": fraction}}
                    for case, fraction in (("a", 1.25), ("b", 1.0), ("c", 1.5))])
        self.assertIn("It is 1 to 1.5.", folder.page())

    def test_long_pages_are_refused(self):
        with self.assertRaisesRegex(ValueError, "3001 words"):
            Project(page="word " * 3001).run()

    def test_null_is_no_number(self):
        folder = Project(page=f"{{{{table interval}}}}\n\n{MISSED}\n")
        row = interval_row("wavelet-97", "clip2", 1.0, 5.0)
        row["counts"]["tetrahedra"] = None
        claim = {"text": "is faster", "met": False, "cases": [{"case": "wavelet-97", "number": None, "met": False}]}
        folder.add([row], claims=[claim])
        page = folder.page()
        self.assertIn("| no number | 5 |", page)
        self.assertIn("wavelet-97 no number.", page)

    def test_a_changed_page_is_found(self):
        folder = Project()
        folder.add(FAST)
        folder.run()
        self.assertEqual(folder.run("--check"), 0)
        path = folder.root / "Documentation" / "guide" / "performance.md"
        path.write_text(path.read_text(encoding="utf-8").replace("5 / 100", "6 / 100"), encoding="utf-8")
        self.assertEqual(folder.run("--check"), 1)

    def test_a_changed_measurement_is_found(self):
        folder = Project()
        folder.add(FAST)
        folder.run()
        folder.add([dict(row, ratio=row["ratio"] + 1) for row in FAST])
        self.assertEqual(folder.run("--check"), 1)

    def test_numbers_typed_into_the_readme_are_refused(self):
        folder = Project()
        folder.add(FAST)
        path = folder.root / "README.md"
        path.write_text(path.read_text(encoding="utf-8") + "It is 4.8 times faster.\n", encoding="utf-8")
        with self.assertRaisesRegex(ValueError, "typed by hand"):
            folder.run("--check")

    def test_pages_of_the_guide(self):
        folder = Project()
        folder.add([dict(row, method="threads-2") for row in FAST[:1]])
        guide = folder.root / "Documentation" / "guide"
        examples = folder.root / "Examples" / "Guide"
        for path in (guide, examples):
            path.mkdir(parents=True, exist_ok=True)
        page = guide / "intervals.md"
        page.write_text("<!-- value interval.second-images -->9<!-- / --> times\n", encoding="utf-8")
        self.assertEqual(folder.run("--check"), 1)
        folder.run()
        self.assertEqual(folder.run("--check"), 0)
        text = page.read_text(encoding="utf-8")
        self.assertEqual(text, "<!-- value interval.second-images -->5<!-- / --> times\n")
        page.write_text(text + "It is 4.8 times faster.\n", encoding="utf-8")
        self.assertEqual(folder.run("--check"), 0)
        (examples / "intervals.py").touch()
        with self.assertRaisesRegex(ValueError, "typed by hand"):
            folder.run("--check")

    def test_numbers_typed_by_hand_are_refused(self):
        for words in ("It is 4.8 times faster.", "It takes 12 ms.", "That is 5 % more.", "It is off by 1e-6."):
            with self.assertRaisesRegex(ValueError, "typed by hand"):
                Project(page=words + "\n").run()
        for words in ("512² pixels, VTK 9.1, two threads.", "`0.5`", "{{\"0.5\"}} of a cell"):
            Project(page=words + "\n").run()

    def test_unknown_names_are_refused(self):
        for field in ("{{table nothing}}", "{{value nothing}}", "{{nothing}}"):
            with self.assertRaises(ValueError):
                Project(page=field + "\n").run()

    def test_ambiguous_rows_are_refused(self):
        folder = Project()
        folder.add(FAST + FAST)
        with self.assertRaisesRegex(ValueError, "2 rows"):
            folder.run()

    def test_the_folder_has_the_version(self):
        folder = Project()
        folder.add(FAST)
        (folder.data / "vtk-9.1").rename(folder.data / "vtk-9.3")
        with self.assertRaisesRegex(ValueError, "is of VTK 9.1"):
            folder.run()

    def test_a_report_is_split(self):
        folder = Project()
        folder.add(FAST)
        report = folder.data / "vtk-9.1" / "interval.json"
        taken = folder.root / "rows.json"
        report.rename(taken)
        folder.run("--take", str(taken))
        self.assertEqual(json.loads(report.read_text(encoding="utf-8")), json.loads(taken.read_text(encoding="utf-8")))


class TestNumbers(unittest.TestCase):
    def test_short(self):
        for number, text in ((0, "0"), (12, "12"), (1234567, "1,234,567"), (4.8312, "4.83"), (103.4, "103"),
                             (1234.5, "1,234"), (0.05, "0.05"), (1.234e-7, "1.23e-7"), (2e-5, "2e-5")):
            self.assertEqual(short(number), text)

    def test_seconds(self):
        for number, text in ((57, "57 s"), (1.0, "1 s"), (0.9999, "1 s"), (0.107, "107 ms"), (0.0038, "3.8 ms"),
                             (2e-6, "2 µs"), (12e-6, "12 µs")):
            self.assertEqual(seconds(number), text)


if __name__ == "__main__":
    # The temporary directories are removed with their objects.
    unittest.main(warnings="ignore")
