"""The files that others read of this repository: workflows, issue forms, citation. They are valid, and what
they call exists."""
import pathlib
import re
import subprocess
import unittest

import yaml

ROOT = pathlib.Path(__file__).resolve().parents[2]
# what a workflow calls by its path
SCRIPT = re.compile(r"(?:^|[\s;&|])(?:\./|\.\./)?((?:scripts|\.ci)/[\w./-]+)")


def read(path):
    return yaml.safe_load(path.read_text(encoding="utf-8"))


def workflows():
    return sorted((ROOT / ".github/workflows").glob("*.yml"))


def commands(workflow):
    """The shell commands of all its steps."""
    return [step["run"] for job in workflow["jobs"].values() for step in job["steps"] if "run" in step]


class Workflows(unittest.TestCase):
    def test_each_has_a_trigger_and_steps(self):
        self.assertGreaterEqual(len(workflows()), 3)
        for path in workflows():
            with self.subTest(path=path.name):
                workflow = read(path)
                self.assertIn(True, workflow)  # `on`, as YAML 1.1 reads it
                for job in workflow["jobs"].values():
                    self.assertIn("runs-on", job)
                    for step in job["steps"]:
                        self.assertEqual(("run" in step) + ("uses" in step), 1, step)

    def test_call_scripts_that_exist_in_shell_that_parses(self):
        called = set()
        for path in workflows():
            for command in commands(read(path)):
                with self.subTest(path=path.name, command=command):
                    subprocess.run(["bash", "-n"], input=command, text=True, check=True)
                    for script in SCRIPT.findall(command):
                        called.add(script)
                        self.assertTrue((ROOT / script).stat().st_mode & 0o100, script)
        self.assertLessEqual({".ci/run", "scripts/test-recipe", "scripts/package"}, called)

    def test_presets_and_packages_they_name_exist(self):
        groups = {line.split()[0] for line in (ROOT / "scripts/packages.txt").read_text().splitlines()
                  if line and line[0] != "#"}
        presets = (ROOT / "CMakePresets.json").read_text()
        for path in workflows():
            text = "\n".join(commands(read(path)))
            for names in re.findall(r"scripts/install-packages(.*)", text):
                self.assertLessEqual(set(names.split()), groups)
            for preset in re.findall(r"--preset (\w+)", text):
                self.assertIn(f'"name": "{preset}"', presets)


class Dockerfile(unittest.TestCase):
    def test_calls_scripts_that_exist_in_shell_that_parses(self):
        lines = re.findall(r"^RUN (.*)", (ROOT / "Dockerfile").read_text(encoding="utf-8"), re.M)
        self.assertGreaterEqual(len(lines), 3)
        for line in lines:
            with self.subTest(line=line):
                self.assertFalse(line.endswith("\\"), "scripts/fresh-machine --dockerfile reads single lines")
                subprocess.run(["bash", "-n"], input=line, text=True, check=True)
                for script in SCRIPT.findall(line):
                    self.assertTrue((ROOT / script).stat().st_mode & 0o100, script)


class IssueForms(unittest.TestCase):
    def test_have_what_a_form_needs(self):
        forms = [path for path in (ROOT / ".github/ISSUE_TEMPLATE").glob("*.yml") if path.name != "config.yml"]
        self.assertEqual({path.stem for path in forms}, {"bug", "wrong-number", "engine"})
        for path in forms:
            with self.subTest(path=path.name):
                form = read(path)
                self.assertLessEqual({"name", "description", "body"}, set(form))
                identities = [field["id"] for field in form["body"]]
                self.assertEqual(len(identities), len(set(identities)))
                for field in form["body"]:
                    self.assertIn(field["type"], {"input", "textarea", "dropdown", "checkboxes"})
                    self.assertIn("label", field["attributes"])


class Citation(unittest.TestCase):
    def test_has_the_keys_that_its_format_requires_and_this_version(self):
        citation = read(ROOT / "CITATION.cff")
        self.assertEqual(citation["cff-version"], "1.2.0")
        self.assertLessEqual({"message", "title", "authors"}, set(citation))
        self.assertEqual(citation["authors"], [{"name": "The tautline developers"}])
        version = re.search(r"project\(tautline VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)
        self.assertEqual(citation["version"], version)


if __name__ == "__main__":
    unittest.main()
