/** Answers of HTTP: errors and JSON, documents with tags, and bytes that are sent without a waiting thread. */
package org.jsmesh.servlet.http;
