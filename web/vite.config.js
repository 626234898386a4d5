// SPDX-License-Identifier: Apache-2.0
import { readFileSync } from "node:fs";

import { defineConfig } from "vite";

// One script for the page of a run, one for that of a study ("vite build --mode study"), one for that
// of the editor of cases ("--mode edit").
const pages = {
  viewer: { entry: "src/main.ts", libraries: ["three", "uplot"] },
  study: {
    entry: "src/study/main.ts",
    libraries: ["d3-array", "d3-contour", "d3-delaunay", "delaunator", "robust-predicates"],
  },
  edit: { entry: "src/edit/main.ts", libraries: [] },
};

// The licences ask that their text goes wherever the code goes, which is every page.
function licences(libraries) {
  const text = libraries.map((name) => {
    const licence = readFileSync(new URL(`node_modules/${name}/LICENSE`, import.meta.url), "utf8");
    return `${name}\n${licence.trim()}`;
  });
  if (libraries.length === 0) return "/*! Kerf, Apache-2.0. */";
  return `/*! Kerf, Apache-2.0. With these libraries:\n\n${text.join("\n\n")}\n*/`;
}

// Inside a page, these would end or reopen the element that the bundle is put into.
const unsafe = [/<\/script/i, /<script/i, /<!--/, /<\/style/i];

const safeToInline = (libraries) => ({
  name: "kerf-safe-to-inline",
  generateBundle(_options, bundle) {
    for (const [name, part] of Object.entries(bundle)) {
      const text = part.type === "chunk" ? part.code : String(part.source);
      const found = unsafe.find((pattern) => pattern.test(text));
      if (found) this.error(`${name} holds ${found} and cannot be put into a page`);
      if (part.type !== "chunk") continue;
      const packages = Object.keys(part.modules).map((path) => path.match(/node_modules\/((?:@[^/]+\/)?[^/]+)/)?.[1]);
      const unnamed = packages.find((one) => one !== undefined && !libraries.includes(one));
      if (unnamed) this.error(`${name} holds ${unnamed}, whose licence is not at its head`);
      part.code = `${licences(libraries)}\n${part.code}`;
    }
  },
});

export default defineConfig(({ mode }) => {
  const name = mode in pages ? mode : "viewer";
  const { entry, libraries } = pages[name];
  return {
    publicDir: false,
    plugins: [safeToInline(libraries)],
    build: {
      target: "es2022",
      cssCodeSplit: false,
      emptyOutDir: name === "viewer",
      chunkSizeWarningLimit: 1000,
      lib: { entry, formats: ["iife"], name: "kerf", fileName: () => `${name}.js`, cssFileName: name },
    },
  };
});
