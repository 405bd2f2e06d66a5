// physx-js-webidl is built for the web alone and refuses node: node is hidden while it starts, and its WebAssembly handed over.

import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

export async function loadPhysx() {
  const { versions } = process;
  const file = createRequire(import.meta.url).resolve("physx-js-webidl").replace(/mjs$/, "wasm");
  Object.defineProperty(process, "versions", { value: { ...versions, node: undefined }, configurable: true });
  globalThis.window = globalThis;
  try {
    return await (await import("physx-js-webidl")).default({ wasmBinary: readFileSync(file) });
  } finally {
    Object.defineProperty(process, "versions", { value: versions, configurable: true });
    delete globalThis.window;
  }
}
