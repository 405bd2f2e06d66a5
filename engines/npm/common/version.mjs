// The version of an engine that cannot be asked for it: what npm has installed.

import { readFileSync } from "node:fs";

/** Of `name` in node_modules beside the file at `url`. */
export function installedVersion(url, name) {
  return JSON.parse(readFileSync(new URL(`node_modules/${name}/package.json`, url), "utf8")).version;
}
