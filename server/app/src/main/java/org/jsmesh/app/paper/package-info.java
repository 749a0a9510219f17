/** The experiments of Chen and Nishita 2002 on this machine: their five tables, and figures 8, 9 and 10. */
package org.jsmesh.app.paper;
