// Loads the decoder that TeaVM compiled to WebAssembly GC. TeaVM's own loader builds its glue with `new Function`, which a strict
// Content-Security-Policy forbids; the decoder needs only the part of the glue below, which is plain functions.

const PAGE_SHIFT = 16;
const MAX_MEMORY = 0x7fffffff;

/** Fetches, compiles and starts the module; resolves to the exported methods. */
export async function loadWebAssembly(url) {
  const module = await compile(url);
  const missing = WebAssembly.Module.imports(module).filter((i) => i.module === 'wasm:js-string');
  if (missing.length > 0) throw new Error('this browser lacks the string functions of WebAssembly');
  const exports = {};
  const context = { instance: null };
  const glue = { ...memoryGlue(module), ...exceptionGlue(), ...objectGlue(context, exports), teavmMath: Math };
  glue.teavmDate = { currentTimeMillis: () => Date.now() };
  for (const { module: part, name } of WebAssembly.Module.imports(module)) {
    if (glue[part]?.[name] === undefined) throw new Error(`the decoder asks for ${part}.${name}, which its loader lacks`);
  }
  context.instance = await WebAssembly.instantiate(module, glue);
  for (const [name, value] of Object.entries(context.instance.exports)) {
    // A method of the main class is exported as a global that holds the function.
    if (value instanceof WebAssembly.Global) Object.defineProperty(exports, name, { get: () => value.value });
  }
  return exports;
}

async function compile(url) {
  const options = { builtins: ['js-string'] };
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url}: HTTP status ${response.status}`);
  return WebAssembly.compile(await response.arrayBuffer(), options);
}

function memoryGlue(module) {
  const sections = WebAssembly.Module.customSections(module, 'teavm.memoryRequirements');
  const needs = sections.length === 1 ? JSON.parse(new TextDecoder().decode(sections[0])) : {};
  const heapOffset = ((needs.dataSize ?? 0) + 7) & ~7;
  const initial = Math.max(needs.min ?? 0, 1);
  const memory = new WebAssembly.Memory({ initial, maximum: ((MAX_MEMORY - 1) >> PAGE_SHIFT) + 1 });
  return {
    env: { memory },
    teavmMemory: {
      linearMemory: () => memory.buffer,
      notifyHeapResized() {},
      heapOffset: new WebAssembly.Global({ value: 'i32', mutable: false }, heapOffset),
      maxSize: new WebAssembly.Global({ value: 'i32', mutable: false }, MAX_MEMORY),
    },
  };
}

/** Exceptions stay inside the decoder, so they need no stack. */
function exceptionGlue() {
  return { teavm: { takeStackTrace: () => ({ getStack: () => [] }), decorateException() {} } };
}

/** What TeaVM calls to see JavaScript's objects and to export its methods. */
function objectGlue(context, exports) {
  const same = (value) => value;
  const javaObject = Symbol('javaObject');
  const wrappers = new WeakMap();
  const resolve = (name) => globalThis[name];
  const wrap = (object) => context.instance.exports['teavm.jso.createWrapper'](object);
  const glue = {
    stringBuiltinsSupported: () => 1,
    isUndefined: (value) => (value === undefined ? 1 : 0),
    unwrapBoolean: (value) => (value ? 1 : 0),
    wrapBoolean: (value) => !!value,
    getProperty: (object, name) => (object === null ? resolve(name) : object[name]),
    setProperty(object, name, value) {
      object[name] = value;
    },
    global: resolve,
    instanceOf: (value, type) => value instanceof type,
    createClass: () => class {},
    defineFunction: (method) => (...args) => method(...args),
    defineMethod() {},
    defineStaticMethod(type, name, method) {
      type[name] = (...args) => method(...args);
    },
    javaObjectToJS: (instance, type) => (instance === null ? null : Object.assign(new type(), { [javaObject]: instance })),
    unwrapJavaObject: (object) => object[javaObject],
    asFunction: (object, name) => (object == null ? null : (...args) => object[name](...args)),
    wrapObject(object) {
      if (object === null) return null;
      if (typeof object !== 'object' && typeof object !== 'function') return wrap(object);
      const known = object[javaObject] ?? wrappers.get(object);
      if (known !== undefined) return known;
      const wrapper = wrap(object);
      wrappers.set(object, wrapper);
      return wrapper;
    },
    jsExports: () => exports,
  };
  for (const type of ['Byte', 'Short', 'Char', 'Int', 'Long', 'Float', 'Double']) {
    glue[`wrap${type}`] = same;
    glue[`unwrap${type}`] = same;
  }
  for (let i = 0; i <= 8; i++) {
    glue[`createFunction${i}`] = createFunction;
    glue[`callFunction${i}`] = (method, ...args) => method(...args);
    glue[`callMethod${i}`] = (object, name, ...args) => (object === null ? resolve(name)(...args) : object[name](...args));
    glue[`construct${i}`] = (type, ...args) => new type(...args);
    glue[`arrayOf${i}`] = (...args) => args;
  }
  return { teavmJso: glue };
}

/** The script fragments of TeaVM's class library that the decoder reaches; they come as text. */
function createFunction(...parts) {
  const body = parts.pop();
  const named = /^\s*return (\w+);\s*$/.exec(body);
  const index = named ? parts.indexOf(named[1]) : -1;
  if (index >= 0) return (...args) => args[index];
  if (/^\s*\{\s*return \{\};\s*\}\s*$/.test(body)) return () => ({});
  throw new Error(`the decoder's loader lacks the function "${body}"`);
}
