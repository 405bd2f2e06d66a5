// The last of what the page says: how engines model a cable, how to read it all, what made it.
#include <fmt/format.h>

#include "bench/report/html/page.hpp"
#include "bench/report/html/parts.hpp"
#include "bench/report/tables.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t longest_sentence = 1000;

std::string model_html(const ordered_json& model, const std::string& id) {
  std::string out = fmt::format("<h4>{}</h4>\n<p>{}</p>\n", html_text(text_of(model, "name")),
                                html_text(text_of(model, "sentence"), longest_sentence));
  HtmlTable settings(id, "Settings that are not the engine’s default.",
                     {{"", "setting", "", "", false},
                      {"", "value", "", "", false},
                      {"", "reason", "", "", false}});
  for (const ordered_json& setting : model.at("settings")) {
    settings.add({row_heading(text_of(setting, "name")), word_cell(text_of(setting, "value")),
                  word_cell(text_of(setting, "reason"), longest_sentence)});
  }
  return settings.empty() ? out + "<p class=\"note\">Every setting is the engine’s default.</p>\n"
                          : out + settings.html();
}

std::string fact(const std::string& name, const std::string& html) {
  return fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", name, html);
}

std::string megabytes(const ordered_json& bytes) {
  return fmt::format("{:.0f} MB", bytes.get<double>() / 1e6);
}

}  // namespace

std::string models_section(const ordered_json& report) {
  std::string out = "<section id=\"models\">\n<h2>How each engine models a cable</h2>\n";
  std::size_t table = 0;
  for (const ordered_json& engine : report.at("engines")) {
    out += fmt::format("<h3>{}</h3>\n", html_text(text_of(engine, "name")));
    if (!engine.at("problem").is_null()) {
      out += fmt::format("<p class=\"note\">{}{}</p>\n",
                         engine.at("missing").get<bool>() ? "Not here: " : "",
                         html_text(text_of(engine, "problem")));
      continue;
    }
    out +=
        fmt::format("<p class=\"note\">Version {}, {}.</p>\n",
                    html_text(text_of(engine, "version")), html_text(text_of(engine, "precision")));
    for (const ordered_json& model : engine.at("models")) {
      out += model_html(model, fmt::format("settings-{}", ++table));
    }
  }
  return out + "</section>\n";
}

std::string reading_section(const ordered_json& report) {
  std::string out =
      "<section id=\"reading\">\n<h2>How to read this page</h2>\n<ul class=\"reading\">\n";
  const std::string list = how_to_read(report);
  constexpr std::string_view bullet = "- ";
  for (std::size_t at = 0; at < list.size();) {
    const std::size_t end = std::min(list.find('\n', at), list.size());
    const std::string item = list.substr(at + bullet.size(), end - at - bullet.size());
    out += fmt::format("<li>{}</li>\n", html_prose(item));
    at = end + 1;
  }
  return out + "</ul>\n</section>\n";
}

std::string context_section(const ordered_json& report) {
  const ordered_json& context = report.at("context");
  std::string out = "<section id=\"context\">\n<h2>Context</h2>\n<dl>\n";
  out += fact("command",
              "<code>" + html_text(text_of(context, "command"), longest_sentence) + "</code>");
  out +=
      fact("data", "<a href=\"report.json\">report.json</a>, <a href=\"report.md\">report.md</a>");
  out += fact("started",
              html_text(text_of(context, "started")) +
                  fmt::format(", took {:.1f} s; {} of {} runs kept from before",
                              context.at("elapsed").get<double>(), context.at("kept_runs").dump(),
                              report.at("planned_runs").dump()));
  out += fact("tautline",
              html_text(text_of(report.at("program"), "version")) + ", commit <code>" +
                  html_text(member(context, "commit").is_string() ? text_of(context, "commit")
                                                                  : "unknown") +
                  "</code>");
  out += fact("built by",
              html_text(text_of(context, "compiler")) + ", " +
                  html_text(text_of(context, "build_type")) + ", <code>" +
                  html_text(member(context, "flags").is_string() ? text_of(context, "flags") : "") +
                  "</code>");
  out += fact("machine", html_text(text_of(context, "processor")) +
                             fmt::format(", {} cores", context.at("cores").dump()));
  out +=
      fact("memory", "at most " + megabytes(context.at("program_memory")) + " in the program and " +
                         megabytes(context.at("worker_memory")) + " in a worker");
  return out + "</dl>\n</section>\n";
}

}  // namespace tautline::bench
