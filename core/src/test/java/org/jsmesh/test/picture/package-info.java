/**
 * Pictures of meshes drawn without any graphics library, and how far two pictures agree: the measure for what the
 * viewers draw.
 */
package org.jsmesh.test.picture;
