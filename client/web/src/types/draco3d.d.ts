// Draco's functions are made by Emscripten, which writes no types.
declare module 'draco3d';
