package org.jsmesh.files.gltf.json;

/**
 * Keys of what jSM itself writes into a GLB file, so that reading it gives the same mesh. Each is in an object under
 * {@link #JSM} in the {@code extras} of an accessor, a material or an image.
 */
public final class GltfExtras {
    /** Name of the object in the extras. */
    public static final String JSM = "jsm";

    /** Of an accessor: the name of the channel. */
    public static final String NAME = "name";

    /** Of an accessor: the meaning of the channel, a name of {@link org.jsmesh.mesh.Channel.Semantic}. */
    public static final String SEMANTIC = "semantic";

    /**
     * Of an accessor: the type of the channel, a name of {@link org.jsmesh.mesh.Channel.Type}. The numbers of the
     * accessor, as they are and not as parts of their largest, are those of the channel.
     */
    public static final String TYPE = "type";

    /** Of an accessor: the place of the channel among those of the mesh. */
    public static final String ORDER = "order";

    /** Of an accessor: true where linear light of 16 bits stands for levels of a screen of 8 bits. */
    public static final String SCREEN = "screen";

    /**
     * Of an accessor: the attribute of the primitive that has the values themselves. This one is for other programs.
     */
    public static final String COPY_OF = "copyOf";

    /** Of a material: the parameters of a definition of another format, each an array of its key and numbers. */
    public static final String PARAMETERS = "parameters";

    /** Of a material: the textures of a definition of another format, each an array of its key and path. */
    public static final String TEXTURES = "textures";

    /** Of a material: the number of the material that this one is, without images. */
    public static final String SAME_AS = "sameAs";

    /** Of an image: its path, where its name does not give it. */
    public static final String PATH = "path";

    private GltfExtras() {}
}
