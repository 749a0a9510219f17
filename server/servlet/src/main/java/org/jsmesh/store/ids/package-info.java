/** The ids of models, made of the paths of their files. */
package org.jsmesh.store.ids;
