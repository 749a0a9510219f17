/**
 * Buckets of Amazon S3, and of services that speak its protocol, as {@linkplain org.jsmesh.objects stores of objects}.
 * {@link org.jsmesh.objects.ObjectStores#open} finds it by the scheme of an address: {@code s3://bucket/prefix}.
 * Credentials, region and endpoint come from where the AWS SDK and the AWS command take them: system properties,
 * environment variables, {@code ~/.aws}, the role of the machine.
 */
package org.jsmesh.s3;
