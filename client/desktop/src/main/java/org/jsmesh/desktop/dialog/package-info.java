/** The questions that a window asks, and the words of its help. */
package org.jsmesh.desktop.dialog;
