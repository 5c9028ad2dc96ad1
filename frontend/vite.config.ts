import react from "@vitejs/plugin-react";
import { defineConfig } from "vitest/config";

const server = "http://127.0.0.1:8000";

export default defineConfig({
  plugins: [react()],
  server: {
    host: "127.0.0.1",
    // The rules' pages are read from ../docs/rules.
    fs: { allow: [".."] },
    proxy: { "/api": server, "/healthz": server, "/readyz": server },
  },
  build: {
    // The page's Content-Security-Policy allows nothing but its own files, so nothing may be inlined.
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 1500,
  },
  test: {
    environment: "jsdom",
    setupFiles: ["src/setup.test-environment.ts"],
    restoreMocks: true,
  },
});
