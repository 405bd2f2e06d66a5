#include "bench/report/manifest.hpp"
#include "bench/report/json/fields.hpp"

namespace tautline::bench {

template <class Visitor>
void fields(Visitor& visit, Manifest::Program& program) {
  visit("version", program.version);
  visit("commit", program.commit);
  visit("hash", program.hash);
}

template <class Visitor>
void fields(Visitor& visit, Manifest::Engine& engine) {
  fields(visit, engine.row);
  visit("plugin", engine.plugin);
}

template <class Visitor>
void fields(Visitor& visit, Manifest& manifest) {
  visit("program", manifest.program);
  visit("shard", manifest.shard);
  visit("options", manifest.options);
  visit("models", manifest.models);
  visit("engines", manifest.engines);
  visit("cases", manifest.cases);
}

std::string manifest_json(const Manifest& manifest) {
  Json json = {{"schema", manifest_schema}};
  json.update(json_of(manifest));
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::optional<Manifest> manifest_from(std::string_view text) {
  try {
    const Json json = Json::parse(text);
    if (json.at("schema") != manifest_schema) {
      return std::nullopt;
    }
    Manifest manifest;
    read(json, manifest);
    for (Manifest::Engine& engine : manifest.engines) {
      complete(engine.row);
    }
    return manifest;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace tautline::bench
