package org.jsmesh.objects;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.DirectoryStream;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jsmesh.files.AtomicFiles;
import org.jsmesh.files.PathNames;
import org.jsmesh.lock.LockedFile;

/**
 * The files of a folder as objects. Their content types are not kept. A listing enters no folder by a link. Conditions
 * hold among all who write through this class, on one machine: they lock a hidden file in the folder.
 */
public final class FolderObjectStore implements ObjectStore {
    /** In what Java tells of a file on Unix: {@code (dev=fe01,ino=123)}. */
    private static final Pattern INODE = Pattern.compile("\\bino=(\\d+)");

    private static final String LOCK = ".jsm-objects.lock";
    private static final long LOCK_PAUSE_MILLIS = 5;
    private static final long LONGEST_WAIT_NANOS = TimeUnit.SECONDS.toNanos(60);

    private final Path folder;

    /** @param folder need not exist; it is made when something is written */
    public FolderObjectStore(Path folder) {
        this.folder = folder.toAbsolutePath().normalize();
    }

    /** {@return the folder} */
    public Path folder() {
        return folder;
    }

    @Override
    public String address() {
        return folder.toString();
    }

    private Path file(String key) {
        return folder.resolve(ObjectKeys.check(key));
    }

    @Override
    public Optional<StoredObject> find(String key) throws IOException {
        return Optional.ofNullable(describe(key, file(key)));
    }

    private static StoredObject describe(String key, Path file) throws IOException {
        try {
            BasicFileAttributes a = Files.readAttributes(file, BasicFileAttributes.class);
            if (!a.isRegularFile()) return null;
            // Every version is a file of its own, which gets the name when it is whole.
            String tag = a.size() + "-" + a.lastModifiedTime().to(TimeUnit.NANOSECONDS) + "-" + number(a.fileKey());
            return new StoredObject(key, a.size(), tag, a.lastModifiedTime().toInstant());
        } catch (NoSuchFileException | NotDirectoryException e) {
            return null;
        } catch (FileSystemException e) {
            // A name in the path is that of a file, for instance.
            if (!Files.exists(file)) return null;
            throw e;
        }
    }

    /**
     * The number of a file on its disk, which all machines see that share it. The number of the disk differs between
     * them.
     */
    static String number(Object fileKey) {
        Matcher inode = INODE.matcher(String.valueOf(fileKey));
        return inode.find() ? inode.group(1) : "";
    }

    @Override
    public InputStream open(String key) throws IOException {
        return Files.newInputStream(file(key));
    }

    @Override
    public void read(StoredObject object, long offset, ByteBuffer into) throws IOException {
        Path file = file(object.key());
        try (FileChannel channel = FileChannel.open(file, StandardOpenOption.READ)) {
            StoredObject there = describe(object.key(), file);
            if (there == null || !there.tag().equals(object.tag()) || there.bytes() != object.bytes())
                throw changed(file);
            while (into.hasRemaining()) {
                int count = channel.read(into, offset);
                if (count < 0) throw changed(file);
                offset += count;
            }
        } catch (NoSuchFileException e) {
            throw changed(file);
        }
    }

    private static ObjectConflictException changed(Path file) {
        return new ObjectConflictException(file.toString(), "was replaced or removed while it was read. Try again");
    }

    @Override
    public StoredObject put(Upload upload) throws IOException {
        Path file = file(upload.key());
        if (upload.condition().equals(Condition.NONE)) return write(upload, file);
        Files.createDirectories(folder);
        LockedFile lock = lock();
        try {
            if (!upload.condition().holds(describe(upload.key(), file)))
                throw new ObjectConflictException(file.toString(), "was written by somebody else meanwhile. Try again");
            return write(upload, file);
        } finally {
            lock.close();
        }
    }

    private LockedFile lock() throws IOException {
        long begin = System.nanoTime();
        while (true) {
            LockedFile lock = LockedFile.tryLock(folder.resolve(LOCK));
            if (lock != null) return lock;
            if (System.nanoTime() - begin > LONGEST_WAIT_NANOS)
                throw new FileSystemException(
                        folder.toString(), null, "is being written by another run. Wait until that has ended");
            try {
                Thread.sleep(LOCK_PAUSE_MILLIS);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
                throw new FileSystemException(folder.toString(), null, "was waited for, but the wait was ended");
            }
        }
    }

    private static StoredObject write(Upload upload, Path file) throws IOException {
        AtomicFiles.write(file, out -> {
            try (InputStream in = upload.content().open()) {
                in.transferTo(out);
            }
        });
        return describe(upload.key(), file);
    }

    @Override
    public void delete(String key) throws IOException {
        Path file = file(key);
        if (!Files.isRegularFile(file)) return;
        Files.deleteIfExists(file);
        // Buckets have no empty folders.
        for (Path parent = file.getParent(); parent != null && !parent.equals(folder); parent = parent.getParent()) {
            try {
                Files.deleteIfExists(parent);
            } catch (DirectoryNotEmptyException e) {
                return;
            }
        }
    }

    @Override
    public void list(String prefix, String after, Visitor visitor) throws IOException {
        if (Files.isDirectory(folder)) list(folder, "", prefix, after, visitor);
    }

    private static boolean list(Path within, String begin, String prefix, String after, Visitor visitor)
            throws IOException {
        for (String name : names(within, begin, prefix, after, visitor)) {
            boolean isFolder = name.endsWith("/");
            Path path = within.resolve(isFolder ? name.substring(0, name.length() - 1) : name);
            String key = begin + name;
            if (isFolder) {
                if (!list(path, key, prefix, after, visitor)) return false;
            } else {
                StoredObject object = describe(key, path);
                if (object != null && !visitor.visit(object)) return false;
            }
        }
        return true;
    }

    /** Names in a folder that may be or lead to what is looked for, in order; those of folders end with a slash. */
    private static List<String> names(Path within, String begin, String prefix, String after, Visitor visitor)
            throws IOException {
        List<String> names = new ArrayList<>();
        try (DirectoryStream<Path> paths = Files.newDirectoryStream(within)) {
            for (Path path : paths) {
                String name = PathNames.name(path);
                if (name.startsWith(".")) continue;
                // A link may lead upwards.
                boolean isFolder = Files.isDirectory(path, LinkOption.NOFOLLOW_LINKS);
                String key = begin + name + (isFolder ? "/" : "");
                boolean isWanted = key.startsWith(prefix) || isFolder && prefix.startsWith(key);
                boolean isBefore = order(key, after) <= 0 && !(isFolder && after.startsWith(key));
                if (!isWanted || isBefore) continue;
                if (PathNames.areRepresentable(path)) names.add(name + (isFolder ? "/" : ""));
                else visitor.unreadable(key, PathNames.skipped(path));
            }
        } catch (NoSuchFileException e) {
            return List.of(); // It went meanwhile.
        }
        names.sort(FolderObjectStore::order);
        return names;
    }

    private static int order(String a, String b) {
        return Arrays.compareUnsigned(a.getBytes(StandardCharsets.UTF_8), b.getBytes(StandardCharsets.UTF_8));
    }

    @Override
    public void close() {}
}
