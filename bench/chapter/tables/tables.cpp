#include "bench/chapter/tables/tables.hpp"

namespace tautline::bench {

std::vector<ChapterTable> chapter_tables(const ChapterStudy& study) {
  return {chapter_table_5_1(study), chapter_table_5_2(), chapter_table_5_3(study)};
}

}  // namespace tautline::bench
