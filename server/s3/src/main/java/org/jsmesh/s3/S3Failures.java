package org.jsmesh.s3;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.net.UnknownHostException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.util.Objects;
import software.amazon.awssdk.core.exception.AbortedException;
import software.amazon.awssdk.core.exception.ApiCallTimeoutException;
import software.amazon.awssdk.core.exception.SdkException;
import software.amazon.awssdk.services.s3.model.S3Exception;

/** Says what a service's answer means, and what to do. */
final class S3Failures {
    static final int REFUSED = 403;
    static final int MISSING = 404;
    static final int CONFLICT = 409;
    static final int FAILED_CONDITION = 412;
    static final int BEYOND_END = 416;

    private static final int MOVED = 301;
    private static final int BAD_REQUEST = 400;
    private static final int UNKNOWN_SIGNER = 401;
    private static final int SLOW_DOWN = 429;
    private static final int SERVER_ERROR = 500;

    private S3Failures() {}

    /** The status of an answer; 0 when there was none. */
    static int status(SdkException e) {
        return e instanceof S3Exception answer ? answer.statusCode() : 0;
    }

    /**
     * The same as an exception of input and output.
     *
     * @param address of the object or the store
     * @param right that is needed for what was tried, such as {@code s3:GetObject}
     */
    static IOException of(SdkException e, String address, String right) {
        if (e instanceof AbortedException || Thread.currentThread().isInterrupted()) {
            InterruptedIOException ended = new InterruptedIOException(address + ": was ended");
            ended.initCause(e);
            return ended;
        }
        String code = e instanceof S3Exception answer && answer.awsErrorDetails() != null
                ? Objects.toString(answer.awsErrorDetails().errorCode(), "")
                : "";
        boolean isMissing = status(e) == MISSING && !code.equals("NoSuchBucket") && !code.equals("NoSuchUpload");
        FileSystemException failure = isMissing
                ? new NoSuchFileException(address)
                : new FileSystemException(address, null, reason(e, status(e), code, right));
        failure.initCause(e);
        return failure;
    }

    private static String reason(SdkException e, int status, String code, String right) {
        if (!code.isEmpty()) {
            String known = byCode(code);
            if (known != null) return known;
        }
        return switch (status) {
            case 0 -> withoutAnswer(e);
            case REFUSED ->
                "access is refused (403). Give the credentials in use the right " + right
                        + (right.equals("s3:GetObject")
                                ? ", and s3:ListBucket, without which what does not exist is refused, too"
                                : "");
            case UNKNOWN_SIGNER ->
                "the credentials are not taken (401). Check them, and that they belong to this service";
            case MOVED -> "the bucket is in another region. Set AWS_REGION to that";
            case BAD_REQUEST ->
                "the service does not take the request (400 " + code + "). Check region, endpoint and credentials: "
                        + e.getMessage();
            case CONFLICT -> "the service is busy with another change of it (409 " + code + "). Try again";
            case MISSING -> "is not there (" + code + ")";
            default ->
                status >= SERVER_ERROR || status == SLOW_DOWN
                        ? "the service is overloaded or failing (" + status + " " + code
                                + ") and was asked several times. Try again later"
                        : "the service answers " + status + " " + code + ": " + e.getMessage();
        };
    }

    private static String byCode(String code) {
        return switch (code) {
            case "NoSuchBucket" -> "there is no such bucket. Check its name and the endpoint, or make it first";
            case "PermanentRedirect", "AuthorizationHeaderMalformed", "IllegalLocationConstraintException" ->
                "the bucket is in another region. Set AWS_REGION to that";
            case "RequestTimeTooSkewed" -> "the clock of this machine is wrong. Set it";
            case "InvalidAccessKeyId" ->
                "the service does not know the access key. Check the credentials and the endpoint";
            case "SignatureDoesNotMatch" -> "the secret key does not belong to the access key. Check the credentials";
            case "ExpiredToken" -> "the credentials have expired. Fetch new ones";
            case "NotImplemented" ->
                "the service does not know what is asked of it. One that knows If-Match and If-None-Match on PUT is needed";
            case "EntityTooLarge" -> "is larger than the service takes";
            default -> null;
        };
    }

    private static String withoutAnswer(SdkException e) {
        if (e instanceof ApiCallTimeoutException)
            return "the service did not answer in time. Check the network, or try again later";
        String message = String.valueOf(e.getMessage());
        if (message.contains("credentials") || message.contains("Credentials"))
            return "there are no credentials. Set AWS_ACCESS_KEY_ID and AWS_SECRET_ACCESS_KEY, or AWS_PROFILE, or give "
                    + "the machine a role";
        for (Throwable cause = e; cause != null; cause = cause.getCause()) {
            if (cause instanceof UnknownHostException)
                return "there is no host " + cause.getMessage() + ". Check the endpoint and the network";
            if (cause instanceof IOException)
                return "the service cannot be reached (" + cause.getMessage() + "). Check the endpoint and the network";
        }
        return message;
    }
}
