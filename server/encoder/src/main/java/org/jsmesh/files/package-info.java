/**
 * Many model files in, archives and a report out: reading and writing of model files, encoding in parallel, what an
 * archive holds as JSON.
 */
package org.jsmesh.files;
