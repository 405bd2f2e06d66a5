#!/usr/bin/env python3
"""Run by CTest: what libtautline.so shows and needs, and whether its manual page is right.

  library_test.py LIBRARY FOLDER COMPILER    the library, languages/c, and a compiler of C
"""
import os
import pathlib
import platform
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

LIBRARY, FOLDER, COMPILER = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3]
# RHEL 9 and GCC 11; std::to_chars of a double is the newest of the latter
NEWEST = {"GLIBC": (2, 34), "GLIBCXX": (3, 4, 29), "CXXABI": (1, 3, 13)}
NEEDED = r"libstdc\+\+\.so\.6|libm\.so\.6|libgcc_s\.so\.1|libc\.so\.6|ld-linux-[a-z0-9-]+\.so\.\d"


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


class Symbols(unittest.TestCase):
    def test_shows_what_the_header_declares_and_nothing_else(self):
        shown = {line.split()[-1].split("@")[0] for line in output("nm", "-D", "--defined-only", LIBRARY).splitlines()}
        header = (FOLDER / "include/tautline/tautline.h").read_text()
        declared = set(re.findall(r"^TAUTLINE_API [^;(]*?(tautline_\w+)\(", header, re.MULTILINE))
        self.assertGreater(len(declared), 30)
        self.assertEqual(shown - {"TAUTLINE_0"}, declared)

    @unittest.skipIf(tuple(map(int, re.findall(r"\d+", platform.libc_ver()[1]))) > (2, 36),
                     "a newer C library binds newer names")
    def test_needs_no_newer_libraries(self):
        table = output("objdump", "-T", LIBRARY)
        for name, newest in NEWEST.items():
            versions = [tuple(map(int, found.split("."))) for found in re.findall(rf"\({name}_([0-9.]+)\)", table)]
            self.assertTrue(versions, name)
            self.assertLessEqual(max(versions), newest, name)

    def test_needs_only_what_every_system_has(self):
        headers = output("objdump", "-p", LIBRARY)
        for name in re.findall(r"^\s*NEEDED\s+(\S+)", headers, re.MULTILINE):
            self.assertRegex(name, f"^({NEEDED})$")
        self.assertIn("libtautline.so.0", re.findall(r"^\s*SONAME\s+(\S+)", headers, re.MULTILINE))



class Manual(unittest.TestCase):
    page = (FOLDER / "tautline.3").read_text()

    def test_has_every_prototype_of_the_header(self):
        header = (FOLDER / "include/tautline/tautline.h").read_text()
        synopsis = " ".join(re.sub(r"\\f[BP]", "", self.page).split())
        for prototype in re.findall(r"^TAUTLINE_API ([^;]*;)", header, re.MULTILINE):
            self.assertIn(" ".join(prototype.split()), synopsis)

    def test_has_every_error_and_name(self):
        header = (FOLDER / "include/tautline/tautline.h").read_text()
        errors = re.search(r"enum tautline_status {(.*?)};", header, re.DOTALL)[1]
        self.assertEqual(re.findall(r"TAUTLINE_\w+(?= =)", errors)[1:],
                         re.findall(r"^\.TP\n\.B (TAUTLINE_\w+)", self.page, re.MULTILINE))
        names = self.page[self.page.index(".SH NAME"):self.page.index("\\-")]
        for name in re.findall(r"^TAUTLINE_API [^;(]*?(tautline_\w+)\(", header, re.MULTILINE):
            self.assertRegex(names, rf"\b{name}\b")

    def test_its_example_runs(self):
        example = re.findall(r"^\.EX\n(.*?)^\.EE", self.page, re.DOTALL | re.MULTILINE)[1]
        with tempfile.TemporaryDirectory() as folder:
            source, program = os.path.join(folder, "ball.c"), os.path.join(folder, "ball")
            pathlib.Path(source).write_text(example.replace("\\-", "-").replace("\\\\", "\\"))
            libraries = os.path.dirname(LIBRARY)
            subprocess.run([COMPILER, "-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror", "-o", program, source,
                            f"-I{FOLDER}/include", f"-L{libraries}", "-ltautline", f"-Wl,-rpath,{libraries}"], check=True)
            self.assertEqual(output(program), "1 2 2.5\n")

    @unittest.skipUnless(shutil.which("man"), "no man")
    def test_is_read_without_a_warning(self):
        read = subprocess.run(["man", "--warnings", "-E", "UTF-8", "-l", FOLDER / "tautline.3"], capture_output=True,
                              text=True, env={**os.environ, "MANWIDTH": "100", "LC_ALL": "C.UTF-8"})
        self.assertEqual((read.returncode, read.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
