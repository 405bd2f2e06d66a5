// What the plug-ins of engines/npm import in a page: in the place of engines/protocol/javascript/engine.mjs, which speaks
// over standard input, and of engines/npm/common/version.mjs, which reads a file.

/// The engines that have served themselves, by name.
export const engines = new Map();

export function serve(engine) { engines.set(engine.name, engine); }

export class Unsupported extends Error {}

/// The versions that the page was built with.
export const installedVersion = (_, name) => VERSIONS[name];
