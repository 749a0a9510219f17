import { defineConfig } from 'vite';

// jsm-viewer starts a worker, which is a module: it must not be bundled ahead for development.
export default defineConfig({ base: './', worker: { format: 'es' }, optimizeDeps: { exclude: ['jsm-viewer'] } });
