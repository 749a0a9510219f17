// Installed with the benchmarks alone.
declare module 'esbuild';
