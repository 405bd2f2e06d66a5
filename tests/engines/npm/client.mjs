// A small client of the protocol: starts an engine's folder and asks it.

import { spawn } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { createInterface } from "node:readline";

export const engineFolder = (name) => fileURLToPath(new URL(`../../../engines/npm/${name}`, import.meta.url));

/** Whether what the engine's lock file pins has been fetched. */
export const isFetched = (name) => existsSync(`${engineFolder(name)}/node_modules`);

/** The words of an engine.toml's command that follow `node`, or none where there is no such file. */
function commandOf(folder) {
  const file = `${folder}/engine.toml`;
  if (!existsSync(file)) return ["engine.mjs"];
  const [, words] = readFileSync(file, "utf8").match(/^command = (\[.*\])$/m);
  return JSON.parse(words).slice(1);
}

/** A child of `folder`; ask(method, params) is the result or throws the error. */
export function startChild(folder) {
  const child = spawn(process.execPath, commandOf(folder), { cwd: folder, stdio: ["pipe", "pipe", "inherit"] });
  const waiting = [];
  const ended = new Promise((resolve) => child.on("exit", (code) => resolve(code)));
  ended.then((code) => waiting.splice(0).forEach(({ reject }) => reject(new Error(`the child ended with ${code}`))));
  createInterface({ input: child.stdout }).on("line", (line) => waiting.shift().resolve(line));
  const say = (line) => new Promise((resolve, reject) => {
    waiting.push({ resolve, reject });
    child.stdin.write(line + "\n");
  });
  let id = 0;
  return {
    say, // a line as it stands
    async ask(method, params) {
      const answer = JSON.parse(await say(JSON.stringify({ jsonrpc: "2.0", id: ++id, method, params })));
      if (answer.id !== id) throw new Error(`answer ${answer.id} to question ${id}`);
      if (answer.error) throw Object.assign(new Error(answer.error.message), { code: answer.error.code });
      return answer.result;
    },
    end() {
      child.stdin.end();
      return ended;
    },
  };
}
