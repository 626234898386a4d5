// SPDX-License-Identifier: Apache-2.0
// Plays the moving pictures that are in view, unless the reader prefers a page without motion.
"use strict";
document.addEventListener("DOMContentLoaded", () => {
  const videos = document.querySelectorAll("video.run");
  if (!videos.length || matchMedia("(prefers-reduced-motion: reduce)").matches) return;
  const watcher = new IntersectionObserver((entries) => {
    for (const { target, isIntersecting } of entries) {
      if (isIntersecting) target.play().catch(() => {});
      else target.pause();
    }
  });
  videos.forEach((video) => watcher.observe(video));
});
