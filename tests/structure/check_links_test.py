"""scripts/check-links finds dead links that are planted, and scripts/site makes pages without any."""
import os
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def script(name, *words):
    return subprocess.run([os.path.join(ROOT, "scripts", name), *words], stderr=subprocess.PIPE, text=True, check=False)


class Folder(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = temporary.name

    def write(self, path, text):
        path = os.path.join(self.folder, path)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)

    def says(self, code):
        done = script("check-links", self.folder)
        self.assertEqual(done.returncode, code, done.stderr)
        return done.stderr.replace("check-links: ", "").splitlines()


class CheckLinks(Folder):
    def setUp(self):
        super().setUp()
        self.write("docs/page.md", "# A page: `code`, and more\n\n<a id=\"here\"></a>\n\n## Twice\n\n## Twice\n")
        self.write("site/page.html", "<h1 id=\"top\">A page</h1>")

    def test_follows_what_leads_somewhere(self):
        self.write("README.md", "[a](docs/page.md), [b](docs/page.md#a-page-code-and-more), [c](docs/page.md#here),\n"
                                "[d](docs/page.md#twice-1), [e](#own), [f](docs), [g](https://example.org/none)\n\n## Own\n\n"
                                "`[no](link.md)`\n\n```\n[nor](this.md)\n```\n\n  ~~~\n  [nor](this.md)\n  ~~~\n")
        self.write("site/index.html", "<a href=\"page.html#top\">x</a><a href=\"//example.org/none\">y</a>")
        self.assertEqual(self.says(0), ["every link leads to its place"])

    def test_names_every_dead_link_with_its_line(self):
        self.write("README.md", "\n[a](docs/pages.md) and ![a picture](none.svg)\n[![both](none.png)](docs/page.md#not)\n"
                                "[out](../../etc/passwd)\n[own](#own)\n")
        self.write("site/index.html", "\n<a href=\"none.html\">x</a>\n<img src=\"none.svg\">\n<a href=\"page.html#foot\">y</a>\n")
        self.assertEqual(self.says(1), [
            "README.md:2: docs/pages.md does not exist", "README.md:2: none.svg does not exist",
            "README.md:3: none.png does not exist", "README.md:3: docs/page.md#not: no place of that page has this name",
            "README.md:4: ../../etc/passwd leads out of the folder",
            "README.md:5: #own: no place of that page has this name",
            "site/index.html:2: none.html does not exist", "site/index.html:3: none.svg does not exist",
            "site/index.html:4: page.html#foot: no place of that page has this name", "9 dead links"])

    def test_takes_a_folder_without_links_for_a_mistake(self):
        self.assertIn("no links at all", self.says(1)[0])


class Pages(Folder):
    def test_of_the_checkout_have_no_dead_link(self):
        done = script("check-links")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_of_the_site_have_none_either(self):
        done = script("site", self.folder)
        if "markdown-it-py is not here" in done.stderr:
            self.skipTest(done.stderr)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.says(0), ["every link leads to its place"])
        with open(os.path.join(self.folder, "index.html"), encoding="utf-8") as file:
            first = file.read()
        for heading in ("Start", "Guides", "Reference", "Results", "Internals"):
            self.assertIn(f"<h2>{heading}</h2>", first)
        with open(os.path.join(self.folder, "search_index.js"), encoding="utf-8") as file:
            self.assertIn('"docs/reference/glossary.html"', file.read())

    def test_do_not_replace_a_folder_of_something_else(self):
        self.write("notes.txt", "mine")
        done = script("site", self.folder)
        self.assertIn(done.returncode, (1, 2))
        self.assertTrue(os.path.exists(os.path.join(self.folder, "notes.txt")))


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
