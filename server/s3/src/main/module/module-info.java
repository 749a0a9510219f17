/** Objects in buckets of Amazon S3 and of services that speak its protocol. */
module org.jsmesh.s3 {
    requires transitive org.jsmesh.encoder;
    requires software.amazon.awssdk.auth;
    requires software.amazon.awssdk.awscore;
    requires software.amazon.awssdk.core;
    requires software.amazon.awssdk.http;
    requires software.amazon.awssdk.http.urlconnection;
    requires software.amazon.awssdk.profiles;
    requires software.amazon.awssdk.regions;
    requires software.amazon.awssdk.services.s3;

    exports org.jsmesh.s3;

    provides org.jsmesh.objects.ObjectStoreProvider with
            org.jsmesh.s3.S3ObjectStoreProvider;
}
