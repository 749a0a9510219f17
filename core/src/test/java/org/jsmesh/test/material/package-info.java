/** Small glTF models that show one property of a material each, for tests of what viewers draw. */
package org.jsmesh.test.material;
