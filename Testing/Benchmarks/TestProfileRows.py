# SPDX-License-Identifier: BSD-3-Clause
"""TestProfileRows.py GENERATOR: checks how profile_suites.py evaluates synthetic samples in the format of
perf."""

import sys
import unittest
from pathlib import Path

GENERATOR = Path(sys.argv.pop(1))
sys.path.insert(0, str(GENERATOR))

from profile_suites import PROFILED, joined, name_of, profiled_rows, read_samples, shares  # noqa: E402

OWN = "/build/lib/libInterlumeIntervals.so.0.1.0"
SCRIPT = f"""
   12.500000:     7f1 interlume::(anonymous namespace)::Extractor<false>::ProcessRow<true>(long) ({OWN})
   12.100000:     7f2 clear_page_erms ([kernel.kallsyms])
   12.900000:     7f3 [unknown] (//anon)
   13.000001:     7f4 __memmove_avx512_unaligned_erms (/usr/lib/x86_64-linux-gnu/libc.so.6)
no sample
"""


class TestNames(unittest.TestCase):
    def test_own_functions(self):
        for symbol, name in (
                ("interlume::(anonymous namespace)::Typed<interlume::(anonymous namespace)::Contiguous<unsigned char>, "
                 "float>::Interpolate(int) const", "Typed::Interpolate"),
                ("interlume::RowKernels::FillKeys(int)", "RowKernels::FillKeys"),
                ("vtkIntervalVolume::RequestData(vtkInformation*)", "vtkIntervalVolume::RequestData"),
                ("tbb::detail::d1::start_for<tbb::blocked_range<long long>, "
                 "vtk::FuncCall<interlume::SimplexList::ForEachId<int>::{lambda(long)#1}> >::execute(int&)",
                 "SimplexList::ForEachId"),
                ("void std::__introsort_loop<int*>(int*, int*)", "std::__introsort_loop")):
            self.assertEqual(name_of(symbol, OWN), name)

    def test_others(self):
        for symbol, library, name in (("clear_page_erms", "[kernel.kallsyms]", "kernel (pages)"),
                                      ("do_syscall_64", "[kernel.kallsyms]", "kernel"),
                                      ("[unknown]", "//anon", "compiled shaders"),
                                      ("draw", "/usr/lib/libgallium-24.so", "OpenGL"),
                                      ("llvm::x", "/usr/lib/libLLVM-15.so.1", "OpenGL"),
                                      ("vtkClip", "/usr/lib/libvtkFiltersGeneral-9.1.so.1", "VTK"),
                                      ("__memset_avx2", "/lib/libc.so.6", "C library (memory)"),
                                      ("malloc", "/lib/libc.so.6", "C library")):
            self.assertEqual(name_of(symbol, library), name)


class TestFractions(unittest.TestCase):
    def test_samples_are_in_order_of_time(self):
        self.assertEqual(read_samples(SCRIPT.splitlines(keepends=True)),
                         [(12.1, "kernel (pages)"), (12.5, "Extractor::ProcessRow"), (12.9, "compiled shaders"),
                          (13.000001, "C library (memory)")])

    def test_only_samples_in_runs_count(self):
        samples = read_samples(SCRIPT.splitlines())
        self.assertEqual(shares(samples, [[12.4, 12.6], [12.95, 14]]),
                         (2, {"Extractor::ProcessRow": 0.5, "C library (memory)": 0.5}))
        self.assertEqual(shares(samples, [[0, 1]]), (0, {}))

    def test_rows_are_found(self):
        case, method, parameter = PROFILED["contour"][1][0]
        rows = [{"case": one, "method": method_name, "parameter": which, "spans": [[12, 13]]}
                for one, method_name, which in PROFILED["contour"][1]]
        result = profiled_rows("contour", {"rows": rows}, read_samples(SCRIPT.splitlines()))
        self.assertEqual(len(result), len(rows))
        self.assertEqual((result[0]["case"], result[0]["method"], result[0]["parameter"]),
                         ("contour: " + case, method, parameter))
        self.assertEqual(result[0]["counts"]["samples"], 3)
        with self.assertRaisesRegex(ValueError, "contour has no row"):
            profiled_rows("contour", {"rows": rows[1:]}, [])

    def test_suites_keep_their_conditions(self):
        def results(suite, date):
            return {"vtk": "9.1.0", "conditions": {"date": date, "load": 1, "size": "full"}, "suites": {},
                    "rows": [{"case": case, "method": method, "parameter": parameter, "spans": []}
                             for case, method, parameter in PROFILED[suite][1]]}
        combined = joined("contour", {"rows": [], "conditions": {}}, results("contour", "first"), [])
        combined = joined("interval", combined, results("interval", "second"), [])
        combined = joined("contour", combined, results("contour", "third"), [])
        self.assertEqual([part["date"] for part in combined["conditions"]["parts"]], ["second", "third"])
        self.assertEqual(len(combined["rows"]), len(PROFILED["interval"][1]) + len(PROFILED["contour"][1]))
        self.assertTrue(combined["rows"][0]["case"].startswith("interval: "))


if __name__ == "__main__":
    unittest.main()
