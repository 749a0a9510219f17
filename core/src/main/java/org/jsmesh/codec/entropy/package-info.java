/** Binary range coder with adaptive contexts, and integers, residuals and text coded by it. */
package org.jsmesh.codec.entropy;
