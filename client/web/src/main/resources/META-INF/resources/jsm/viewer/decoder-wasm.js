// @ts-check
// Loads the decoder that TeaVM compiled to WebAssembly GC. TeaVM's own loader builds its glue with `new Function`, which a strict
// Content-Security-Policy forbids; the decoder needs only the part of the glue below, which is plain functions.

const PAGE_SHIFT = 16;
const MAX_MEMORY = 0x7fffffff;

/** @typedef {any} Value of Java or JavaScript, whose type the decoder alone knows */
/** @typedef {(...args: Value[]) => Value} Method */
/** @typedef {Record<string, any>} Glue functions and globals by name */

/**
 * Fetches, compiles and starts the module; resolves to the exported methods.
 *
 * @param {URL} url
 */
export async function loadWebAssembly(url) {
  const module = await compile(url);
  const missing = WebAssembly.Module.imports(module).filter((i) => i.module === 'wasm:js-string');
  if (missing.length > 0) throw new Error('this browser lacks the string functions of WebAssembly');
  /** @type {Record<string, Method>} */
  const exports = {};
  /** @type {WebAssembly.Instance | null} */
  let instance = null;
  const wrap = (/** @type {Value} */ value) => /** @type {any} */ (instance).exports['teavm.jso.createWrapper'](value);
  /** @type {Record<string, Glue>} */
  const glue = { ...memoryGlue(module), ...exceptionGlue(), ...objectGlue(wrap, exports), teavmMath: /** @type {Glue} */ (Math) };
  glue.teavmDate = { currentTimeMillis: () => Date.now() };
  for (const { module: part, name } of WebAssembly.Module.imports(module)) {
    if (glue[part]?.[name] === undefined) throw new Error(`the decoder asks for ${part}.${name}, which its loader lacks`);
  }
  instance = await WebAssembly.instantiate(module, glue);
  for (const [name, value] of Object.entries(instance.exports)) {
    // A method of the main class is exported as a global that holds the function.
    if (value instanceof WebAssembly.Global) Object.defineProperty(exports, name, { get: () => value.value });
  }
  return exports;
}

/**
 * @param {URL} url
 * @returns {Promise<WebAssembly.Module>}
 */
async function compile(url) {
  const options = { builtins: ['js-string'] };
  /** @type {any} TypeScript does not know the options yet. */
  const wasm = WebAssembly;
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url}: HTTP status ${response.status}`);
  return wasm.compile(await response.arrayBuffer(), options);
}

/**
 * @param {WebAssembly.Module} module
 * @returns {Record<string, Glue>}
 */
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

/**
 * Exceptions stay inside the decoder, so they need no stack.
 *
 * @returns {Record<string, Glue>}
 */
function exceptionGlue() {
  return { teavm: { takeStackTrace: () => ({ getStack: () => [] }), decorateException() {} } };
}

/**
 * What TeaVM calls to see JavaScript's objects and to export its methods.
 *
 * @param {Method} wrap makes a Java object of one of JavaScript
 * @param {Record<string, Method>} exports
 * @returns {Record<string, Glue>}
 */
function objectGlue(wrap, exports) {
  /** @type {Method} */
  const same = (value) => value;
  const javaObject = Symbol('javaObject');
  const wrappers = new WeakMap();
  /** @type {(method: Method) => Method} a function of JavaScript for one of Java */
  const calling = (method) => (...args) => method(...args);
  /** @type {Method} */
  const resolve = (name) => /** @type {any} */ (globalThis)[name];
  /** @type {Record<string, Method>} */
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
    defineFunction: calling,
    defineMethod() {},
    defineStaticMethod(type, name, method) {
      type[name] = calling(method);
    },
    javaObjectToJS: (instance, type) => (instance === null ? null : Object.assign(new type(), { [javaObject]: instance })),
    unwrapJavaObject: (object) => object[javaObject],
    asFunction: (object, name) => (object === null || object === undefined ? null : calling((...args) => object[name](...args))),
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

/**
 * The script fragments of TeaVM's class library that the decoder reaches; they come as text.
 *
 * @param {string[]} parts names of the parameters, then the body
 * @returns {Method}
 */
function createFunction(...parts) {
  const body = parts.pop() ?? '';
  const named = /^\s*return (\w+);\s*$/.exec(body);
  const index = named ? parts.indexOf(named[1]) : -1;
  if (index >= 0) return (...args) => args[index];
  if (/^\s*\{\s*return \{\};\s*\}\s*$/.test(body)) return () => ({});
  throw new Error(`the decoder's loader lacks the function "${body}"`);
}
