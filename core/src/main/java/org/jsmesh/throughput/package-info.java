/** Estimate of bytes per second from the arrival times of responses; times are passed in, no clock is read. */
package org.jsmesh.throughput;
