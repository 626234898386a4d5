// SPDX-License-Identifier: Apache-2.0
import { readFileSync } from "node:fs";

import { defineConfig } from "vite";

// Both licences ask that their text goes wherever the code goes, which is every report.
function licences() {
  const text = ["three", "uplot"].map((name) => {
    const licence = readFileSync(new URL(`node_modules/${name}/LICENSE`, import.meta.url), "utf8");
    return `${name}\n${licence.trim()}`;
  });
  return `/*! Kerf, Apache-2.0. With these libraries:\n\n${text.join("\n\n")}\n*/`;
}

// Inside a page, these would end or reopen the element that the bundle is put into.
const unsafe = [/<\/script/i, /<script/i, /<!--/, /<\/style/i];

const safeToInline = {
  name: "kerf-safe-to-inline",
  generateBundle(_options, bundle) {
    for (const [name, part] of Object.entries(bundle)) {
      const text = part.type === "chunk" ? part.code : String(part.source);
      const found = unsafe.find((pattern) => pattern.test(text));
      if (found) this.error(`${name} holds ${found} and cannot be put into a page`);
      if (part.type === "chunk") part.code = `${licences()}\n${part.code}`;
    }
  },
};

export default defineConfig({
  publicDir: false,
  plugins: [safeToInline],
  build: {
    target: "es2022",
    cssCodeSplit: false,
    chunkSizeWarningLimit: 1000,
    lib: { entry: "src/main.ts", formats: ["iife"], name: "kerf", fileName: () => "viewer.js", cssFileName: "viewer" },
  },
});
