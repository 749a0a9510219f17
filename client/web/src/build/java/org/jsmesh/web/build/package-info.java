/**
 * The last step of the build of the page: bundles its modules, names its files after what is in them and packs them.
 */
package org.jsmesh.web.build;
