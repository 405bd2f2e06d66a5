"""A copy of the sources to plant faults in, and what a check of scripts/ says of it."""
import os
import shutil
import subprocess
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
FOLDERS = ["analytic", "bench", "engines"]


class Planted(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.copy = temporary.name
        for folder in FOLDERS:
            shutil.copytree(os.path.join(ROOT, folder), os.path.join(self.copy, folder),
                            ignore=shutil.ignore_patterns("node_modules"))

    def write(self, path, text):
        path = os.path.join(self.copy, path)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)

    def says(self, script, code):
        """What the script says of the copy, which it ends with this exit code for."""
        done = subprocess.run([os.path.join(ROOT, "scripts", script), self.copy],
                              stderr=subprocess.PIPE, text=True, check=False)
        self.assertEqual(done.returncode, code, done.stderr)
        return done.stderr
