"""scripts/check-english finds what is planted in a copy of the sources, and names it."""
import os
import sys
import unittest

from planted import ROOT, Planted


class CheckEnglish(Planted):
    def test_passes_the_sources_as_they_are(self):
        self.assertEqual(self.says("check-english", 0), "check-english: plain\n")

    def test_names_a_word_in_what_is_printed_and_not_in_an_include(self):
        self.write("bench/planted.cpp", '#include "beside.hpp"\nauto planted = "held against it"; // fine\n')
        self.assertEqual(self.says("check-english", 1), 'check-english: bench/planted.cpp:2 prints "held against": compared with\n'
                                       "check-english: 1 breaches\n")

    def test_counts_comments(self):
        self.write("bench/planted.cpp", "/// What is here.\nint planted = 0;  // taut for good\n" * 400)
        found = self.says("check-english", 1)
        self.assertIn("comments of bench/ have a word of WORDS", found)
        self.assertIn("comments of bench/ begin with Of|What|Where|The same|Whether", found)

    def test_names_a_word_on_a_page_and_not_in_its_code(self):
        self.write("docs/page.md", "Any step.\n\n```\nwhatever\n```\n\n`so many`\n")
        self.says("check-english", 0)
        self.write("README.md", "# tautline\n\nIt holds at any step, whatever the case.\n")
        self.assertEqual(self.says("check-english", 1), 'check-english: README.md:3 has "whatever": for any, at every\n'
                         "check-english: 1 such words in README.md, 0 at most\ncheck-english: 2 breaches\n")

    def test_names_a_word_in_a_sentence_that_a_room_prints(self):
        self.write("bench/gate/words.md", "## planted\n\nWhatever the case.\n")
        self.assertIn('bench/gate/words.md:3 has "Whatever": for any, at every\n', self.says("check-english", 1))

    def test_takes_a_quoted_word_and_an_address_for_no_comment(self):
        self.write("bench/planted.cpp", 'auto planted = "https://example.org/of/it";\n' * 400)
        self.says("check-english", 0)


class Subjects(unittest.TestCase):
    def test_are_orders_of_one_thought(self):
        script = os.path.join(ROOT, "scripts", "check-english")
        names = {"__name__": "check_english", "__file__": script}
        with open(script, encoding="utf-8") as file:
            exec(compile(file.read(), script, "exec"), names)  # a script has no suffix to import it by
        wrong = names["wrong_subject"]
        for right in ("Name an option's value", "Pass a case by its name", "Embed the page's scripts", "Bring it", "Exceed the limit", "Cross it"):
            self.assertIsNone(wrong(right), right)
        for bad in ("The report has a page", "Added a page", "Fixes the page", "Moving the page", "name the page",
                    "Name it; write it", "Name it.", "Name what " + "is too long " * 5):
            self.assertIsNotNone(wrong(bad), bad)


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
