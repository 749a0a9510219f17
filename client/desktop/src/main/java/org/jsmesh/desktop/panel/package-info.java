/** What stands beside the picture: resolutions, legend, chart, figures, proof and notes. */
package org.jsmesh.desktop.panel;
