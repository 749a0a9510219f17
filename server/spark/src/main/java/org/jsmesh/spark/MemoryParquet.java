package org.jsmesh.spark;

import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import org.apache.parquet.io.DelegatingPositionOutputStream;
import org.apache.parquet.io.DelegatingSeekableInputStream;
import org.apache.parquet.io.InputFile;
import org.apache.parquet.io.OutputFile;
import org.apache.parquet.io.PositionOutputStream;
import org.apache.parquet.io.SeekableInputStream;

/** A Parquet file that is an array of bytes. */
final class MemoryParquet implements OutputFile {
    private final ByteArrayOutputStream content = new ByteArrayOutputStream();

    byte[] bytes() {
        return content.toByteArray();
    }

    @Override
    public PositionOutputStream create(long blockSizeHint) {
        return new DelegatingPositionOutputStream(content) {
            @Override
            public long getPos() {
                return content.size();
            }
        };
    }

    @Override
    public PositionOutputStream createOrOverwrite(long blockSizeHint) {
        content.reset();
        return create(blockSizeHint);
    }

    @Override
    public boolean supportsBlockSize() {
        return false;
    }

    @Override
    public long defaultBlockSize() {
        return 0;
    }

    static InputFile of(byte[] bytes) {
        return new InputFile() {
            @Override
            public long getLength() {
                return bytes.length;
            }

            @Override
            public SeekableInputStream newStream() {
                return new Input(ByteBuffer.wrap(bytes));
            }
        };
    }

    private static final class Input extends DelegatingSeekableInputStream {
        private final ByteBuffer bytes;

        Input(ByteBuffer bytes) {
            super(new java.io.InputStream() {
                @Override
                public int read() {
                    return bytes.hasRemaining() ? bytes.get() & 0xff : -1;
                }

                @Override
                public int read(byte[] into, int offset, int length) {
                    if (length == 0) return 0;
                    int count = Math.min(length, bytes.remaining());
                    if (count == 0) return -1;
                    bytes.get(into, offset, count);
                    return count;
                }
            });
            this.bytes = bytes;
        }

        @Override
        public long getPos() {
            return bytes.position();
        }

        @Override
        public void seek(long position) throws IOException {
            if (position < 0 || position > bytes.limit())
                throw new EOFException(position + " of " + bytes.limit() + " bytes");
            bytes.position((int) position);
        }
    }
}
