/**
 * A folder that any static host can serve: archives, manifests and catalogue under the servlet's addresses, and the
 * page.
 */
package org.jsmesh.site;
