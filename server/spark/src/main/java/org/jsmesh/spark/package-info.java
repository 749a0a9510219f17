/** Catalogues of millions of models, encoded and published by Apache Spark. */
package org.jsmesh.spark;
