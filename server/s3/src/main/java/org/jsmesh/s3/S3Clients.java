package org.jsmesh.s3;

import java.net.URI;
import java.net.URISyntaxException;
import java.time.Duration;
import java.util.Locale;
import java.util.Optional;
import software.amazon.awssdk.awscore.exception.AwsErrorDetails;
import software.amazon.awssdk.core.checksums.RequestChecksumCalculation;
import software.amazon.awssdk.core.checksums.ResponseChecksumValidation;
import software.amazon.awssdk.core.exception.SdkClientException;
import software.amazon.awssdk.core.exception.SdkException;
import software.amazon.awssdk.http.urlconnection.UrlConnectionHttpClient;
import software.amazon.awssdk.profiles.Profile;
import software.amazon.awssdk.profiles.ProfileFile;
import software.amazon.awssdk.profiles.ProfileFileSystemSetting;
import software.amazon.awssdk.regions.Region;
import software.amazon.awssdk.regions.providers.DefaultAwsRegionProviderChain;
import software.amazon.awssdk.services.s3.S3Client;
import software.amazon.awssdk.services.s3.S3ClientBuilder;
import software.amazon.awssdk.services.s3.S3Configuration;
import software.amazon.awssdk.services.s3.model.HeadBucketRequest;
import software.amazon.awssdk.services.s3.model.S3Exception;
import software.amazon.awssdk.services.s3.presigner.S3Presigner;

/** Clients with the settings of the AWS SDK, and what services that are not Amazon's need beside. */
final class S3Clients {
    private static final Duration CONNECT = Duration.ofSeconds(10);
    private static final Duration SILENCE = Duration.ofSeconds(60);

    /** Properties and variables; those of S3 alone go first. */
    private static final String[][] ENDPOINTS = {
        {"aws.endpointUrlS3", "AWS_ENDPOINT_URL_S3"}, {"aws.endpointUrl", "AWS_ENDPOINT_URL"}
    };

    private static final String OF_PROFILE = "endpoint_url";

    /** So often somebody who waits can hear of a service that was silent once. */
    private static final int TRIES = 3;

    private S3Clients() {}

    /** @param patience how long an answer is waited for; null for as long as may help */
    static S3Client client(Duration patience) {
        URI endpoint = endpoint();
        Duration silence = patience == null ? SILENCE : patience.dividedBy(TRIES);
        UrlConnectionHttpClient.Builder http = UrlConnectionHttpClient.builder()
                .connectionTimeout(silence.compareTo(CONNECT) < 0 ? silence : CONNECT)
                .socketTimeout(silence);
        S3ClientBuilder builder = S3Client.builder().httpClientBuilder(http).region(region(endpoint));
        // A thread that waits for the socket cannot be interrupted: both bounds are needed.
        if (patience != null) builder.overrideConfiguration(c -> c.apiCallTimeout(patience));
        // Amazon's own client follows a bucket to its region.
        if (endpoint == null) return builder.crossRegionAccessEnabled(true).build();
        return builder.endpointOverride(endpoint)
                .forcePathStyle(true)
                // Other services do not know the newer checksums.
                .requestChecksumCalculation(RequestChecksumCalculation.WHEN_REQUIRED)
                .responseChecksumValidation(ResponseChecksumValidation.WHEN_REQUIRED)
                .build();
    }

    /** @param region null for the one that is set */
    static S3Presigner presigner(S3Client client, Region region) {
        URI endpoint = endpoint();
        S3Presigner.Builder builder =
                S3Presigner.builder().s3Client(client).region(region == null ? region(endpoint) : region);
        if (endpoint == null) return builder.build();
        return builder.endpointOverride(endpoint)
                .serviceConfiguration(
                        S3Configuration.builder().pathStyleAccessEnabled(true).build())
                .build();
    }

    /** The region that a bucket is in; null when the service failed rather than answered. */
    static Region regionOf(S3Client client, String bucket) {
        URI endpoint = endpoint();
        if (endpoint != null) return region(endpoint);
        try {
            String region = client.headBucket(
                            HeadBucketRequest.builder().bucket(bucket).build())
                    .bucketRegion();
            return region == null ? region(null) : Region.of(region);
        } catch (S3Exception e) {
            // Who has no right to ask is told as well.
            Optional<String> told = Optional.ofNullable(e.awsErrorDetails())
                    .map(AwsErrorDetails::sdkHttpResponse)
                    .flatMap(answer -> answer.firstMatchingHeader("x-amz-bucket-region"));
            if (told.isPresent()) return Region.of(told.get());
            return e.statusCode() == S3Failures.REFUSED ? region(null) : null;
        } catch (SdkClientException e) {
            return null;
        }
    }

    private static Region region(URI endpoint) {
        String set = setting("aws.region", "AWS_REGION", "region");
        if (set == null && endpoint != null) return Region.US_EAST_1;
        if (set != null) return Region.of(set);
        try {
            return new DefaultAwsRegionProviderChain().getRegion();
        } catch (SdkException e) {
            return Region.US_EAST_1; // Outside of Amazon nobody says another.
        }
    }

    /** Where the service is when it is not Amazon's; null when it is. */
    private static URI endpoint() {
        if (Boolean.parseBoolean(setting(
                "aws.ignoreConfiguredEndpointUrls",
                "AWS_IGNORE_CONFIGURED_ENDPOINT_URLS",
                "ignore_configured_endpoint_urls"))) return null;
        for (String[] names : ENDPOINTS) {
            String property = System.getProperty(names[0]);
            if (isSet(property)) return endpoint(names[0], property);
            String variable = System.getenv(names[1]);
            if (isSet(variable)) return endpoint(names[1], variable);
        }
        Optional<String> set = profile().flatMap(p -> p.property(OF_PROFILE)).filter(S3Clients::isSet);
        return set.isPresent() ? endpoint(OF_PROFILE, set.get()) : null;
    }

    /** @throws IllegalArgumentException that names the setting, when it is no address of a service */
    static URI endpoint(String name, String value) {
        try {
            URI endpoint = new URI(value.trim());
            String scheme = String.valueOf(endpoint.getScheme()).toLowerCase(Locale.ROOT);
            if ((scheme.equals("http") || scheme.equals("https")) && endpoint.getHost() != null) return endpoint;
        } catch (URISyntaxException e) {
            // Told below.
        }
        throw new IllegalArgumentException(
                name + " is '" + value + "', which is no address of a service. Write http:// or https://, a host"
                        + " (letters, digits, dots and hyphens) and perhaps a port: http://localhost:9000");
    }

    private static boolean isSet(String value) {
        return value != null && !value.isBlank();
    }

    private static String setting(String property, String variable, String ofProfile) {
        String value = System.getProperty(property);
        if (value == null) value = System.getenv(variable);
        if (value == null) value = profile().flatMap(p -> p.property(ofProfile)).orElse(null);
        return isSet(value) ? value : null;
    }

    private static Optional<Profile> profile() {
        return ProfileFile.defaultProfileFile().profile(ProfileFileSystemSetting.AWS_PROFILE.getStringValueOrThrow());
    }
}
