package org.jsmesh.encode;

import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.mesh.Sha256;

/** SHA-256 of the platform, which may use an instruction of the processor. */
record PlatformHash(MessageDigest hash) implements MeshIdentity.Hash {
    static MeshIdentity.Hash sha256() {
        try {
            return new PlatformHash(MessageDigest.getInstance("SHA-256"));
        } catch (NoSuchAlgorithmException e) {
            return new Sha256();
        }
    }

    @Override
    public void update(byte[] bytes, int offset, int count) {
        hash.update(bytes, offset, count);
    }

    @Override
    public byte[] digest() {
        return hash.digest();
    }
}
