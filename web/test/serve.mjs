// SPDX-License-Identifier: Apache-2.0
// Starts the program as a server of pages.

import { spawn } from "node:child_process";

/** The process, and the address that it prints. */
export function serve(program, words, cwd = undefined) {
  const server = spawn(program, words, { cwd, stdio: ["ignore", "pipe", "inherit"] });
  const address = new Promise((resolve, reject) => {
    let said = "";
    server.stdout.on("data", (bytes) => {
      said += bytes;
      const found = /http:\/\/\S+/.exec(said);
      if (found) resolve(found[0]);
    });
    server.on("exit", (code) => reject(new Error(`kerf ${words.join(" ")} ended with ${code}: ${said}`)));
  });
  return { server, address };
}
