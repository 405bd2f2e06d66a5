"""scripts/check-includes finds what is planted in a copy of the sources, and names it."""
import sys
import unittest

from planted import Planted


class CheckIncludes(Planted):
    def breaches(self):
        return self.says("check-includes", 1)

    def test_names_a_circle_that_passes_through_a_source(self):
        self.write("bench/base/planted.hpp", '#include "bench/base/planted_too.hpp"\n')
        self.write("bench/base/planted_too.hpp", "#pragma once\n")
        self.write("bench/base/planted_too.cpp", '#include "bench/base/planted.hpp"\n')
        self.assertIn("a circle of includes: bench/base/planted -> bench/base/planted_too -> "
                      "bench/base/planted\n", self.breaches())

    def test_names_a_circle_among_public_headers(self):
        self.write("analytic/include/tautline/planted.hpp", '#include "tautline/planted_too.hpp"\n')
        self.write("analytic/include/tautline/planted_too.hpp", '#include "tautline/planted.hpp"\n')
        self.assertIn("analytic/planted -> analytic/planted_too -> analytic/planted\n", self.breaches())

    def test_names_an_arrow_back_between_rooms(self):
        self.write("bench/base/planted.cpp", '#include "bench/suite/suite.hpp"\n')
        self.assertIn("bench/base/planted.cpp includes bench/suite/suite.hpp: "
                      "bench/base may not use bench/suite\n", self.breaches())

    def test_names_a_room_that_is_not_in_the_table(self):
        self.write("bench/planted/planted.cpp", "")
        self.assertIn("bench/planted is no room", self.breaches())

    def test_names_a_comment_on_a_source_that_is_gone(self):
        self.write("bench/base/planted.cpp", "// as in gone_away" + ".hpp\n")
        self.assertIn("bench/base/planted.cpp: a comment names gone_away.hpp, which does not exist\n",
                      self.breaches())

    def test_names_words_that_nothing_prints(self):
        self.write("bench/gate/words.md", "# Planted\n\n## said\n\nOnce.\n\n## unsaid\n\nNever.\n")
        self.write("bench/gate/planted.cpp", "auto planted = words::said;\n")
        found = self.breaches()
        self.assertIn("bench/gate/words.md: no source of bench/gate/ prints words::unsaid\n", found)
        self.assertNotIn("words::said", found)

    def test_names_a_word_of_the_plane_in_what_serves_every_kind_of_case(self):
        self.write("analytic/loop/planted.hpp", "// its angle\nauto planted = state.angle;\n")
        self.write("analytic/planted.hpp", "auto planted = state.angle;\n")
        found = self.breaches()
        self.assertIn("analytic/loop/planted.hpp:2 names angle, which not every kind of case has\n", found)
        self.assertNotIn("analytic/planted.hpp", found)

    def test_names_a_long_source_and_a_full_folder(self):
        self.write("analytic/planted.cpp", "\n" * 601)
        for number in range(41):
            self.write(f"engines/planted/{number}.cpp", "")
        found = self.breaches()
        self.assertIn("analytic/planted.cpp has 601 lines, 600 at most\n", found)
        self.assertIn("engines/planted/ has 41 files, 40 at most\n", found)
        self.assertIn("analytic/ has ", found)  # its budget has less than 600 lines to spare

    def test_names_a_small_folder_and_a_short_header_for_one_source(self):
        self.write("bench/gate/planted/planted.cpp", '#include "bench/gate/planted/planted.hpp"\n')
        self.write("bench/gate/planted/planted.hpp", "#pragma once\n")
        found = self.breaches()
        self.assertIn("bench/gate/planted/ has 2 sources, 3 at least", found)
        self.assertIn("bench/gate/planted/planted.hpp has 1 lines for bench/gate/planted/planted.cpp alone", found)

    def test_names_json_in_a_header_and_in_too_many_files(self):
        for number in range(9):
            self.write(f"bench/base/planted{number}.cpp", "#include <nlohmann/json.hpp>\n")
        self.write("bench/base/planted.hpp", "#include <nlohmann/json_fwd.hpp>\n")
        found = self.breaches()
        self.assertIn("bench/base/planted.hpp brings nlohmann's JSON to all who include it", found)
        self.assertIn("files of bench/ include nlohmann's JSON, 8 at most", found)


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
