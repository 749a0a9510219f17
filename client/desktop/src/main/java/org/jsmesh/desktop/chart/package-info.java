/** The chart of how a model is loaded. */
package org.jsmesh.desktop.chart;
