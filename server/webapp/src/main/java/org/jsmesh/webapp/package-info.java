/** The web application: the streaming servlet at {@code /m/*}, the page at {@code /}, and the headers that guard it. */
package org.jsmesh.webapp;
