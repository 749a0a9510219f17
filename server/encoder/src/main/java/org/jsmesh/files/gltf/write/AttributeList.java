package org.jsmesh.files.gltf.write;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.jsmesh.files.gltf.json.GltfExtras;
import org.jsmesh.files.gltf.read.ComponentType;
import org.jsmesh.files.gltf.read.NoteText;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;

/**
 * The attributes that the channels of a mesh become. Channels that are glTF's own stay what they are. Others get the
 * name of an attribute with their meaning, and extras that lead back; where such an attribute cannot hold their very
 * values, it is a copy for other programs, and an attribute of the application has the values.
 */
final class AttributeList {
    private final List<VertexAttribute> attributes = new ArrayList<>();
    private final List<String> rounded = new ArrayList<>();
    private final Set<String> names = new HashSet<>();
    private final boolean allOwn;
    private boolean quantized;
    private Channel channel; // the one at hand
    private int order; // its place

    AttributeList(Mesh mesh) {
        allOwn = areOwn(mesh.channels());
        for (Channel own : mesh.channels()) if (OwnNames.isOwn(own)) names.add(OwnNames.attribute(own));
        for (Channel each : mesh.channels()) {
            channel = each;
            add();
            order++;
        }
    }

    /** In the order of the channels. */
    List<VertexAttribute> attributes() {
        return attributes;
    }

    /** Whether an attribute needs the extension for other types than glTF has by itself. */
    boolean isQuantized() {
        return quantized;
    }

    void report(List<String> notes) {
        if (!rounded.isEmpty())
            notes.add("glTF holds these channels in float32 alone, and rounds them: " + NoteText.shown(rounded) + ".");
    }

    /** Whether names, types and order are those that a file of glTF gives. */
    private static boolean areOwn(List<Channel> channels) {
        List<Channel> sorted = new ArrayList<>(channels);
        sorted.sort(Comparator.comparing(Channel::semantic).thenComparing(OwnNames::attribute));
        boolean twice = channels.stream().map(OwnNames::attribute).distinct().count() < channels.size();
        return !twice && sorted.equals(channels) && channels.stream().allMatch(OwnNames::isOwn);
    }

    private void add() {
        if (OwnNames.isOwn(channel)) {
            addOwn();
            return;
        }
        switch (channel.semantic()) {
            case NORMAL -> addNormals();
            case TEXCOORD -> addCoordinates();
            case COLOUR -> addColours();
            default -> addValues();
        }
    }

    private void addOwn() {
        boolean marked = !OwnNames.attribute(channel).equals(channel.name());
        boolean whole = !channel.type().isFloat();
        boolean normalized = whole && (channel.semantic() != Channel.Semantic.CUSTOM || marked);
        quantized |= OwnNames.isQuantized(channel);
        addAs(OwnNames.attribute(channel), type(), normalized, ChannelValues.exact(channel), "");
    }

    private void addNormals() {
        boolean fits = channel.components() == 3 && names.add("NORMAL");
        if (fits && channel.type() == Channel.Type.FLOAT32 && ChannelValues.areUnit(channel)) {
            addAs("NORMAL", type(), false, ChannelValues.exact(channel), "");
            return;
        }
        String values = addValues();
        if (fits) addCopy("NORMAL", ComponentType.FLOAT, ChannelValues.unit(channel), values);
    }

    private void addCoordinates() {
        if (channel.components() != 2) {
            addValues();
            return;
        }
        String name = free("TEXCOORD_");
        if (channel.type() == Channel.Type.INT8 || channel.type() == Channel.Type.INT16) {
            String values = addValues();
            addCopy(name, ComponentType.FLOAT, ChannelValues.numbers(channel), values);
        } else {
            addRounded(name, type() != ComponentType.FLOAT);
        }
    }

    private void addColours() {
        if (channel.components() < 3) {
            addValues();
        } else if (channel.type() == Channel.Type.UINT8 && !channel.isLinearLight()) {
            String screen = GltfExtras.SCREEN;
            addAs(free("COLOR_"), ComponentType.UNSIGNED_SHORT, true, ChannelValues.light(channel), screen);
        } else {
            String name = free("COLOR_");
            String values = addValues();
            addCopy(name, ComponentType.UNSIGNED_SHORT, ChannelValues.light(channel), values);
        }
    }

    /** As an attribute of the application, which may have any numbers but those of 32 bits. */
    private String addValues() {
        StringBuilder name = new StringBuilder("_");
        for (char c : channel.name().toUpperCase(Locale.ROOT).toCharArray())
            if (name.length() < 60) name.append(c >= 'A' && c <= 'Z' || c >= '0' && c <= '9' ? c : '_');
        if (name.length() == 1) name.append("ATTRIBUTE");
        String unique = name.toString();
        for (int i = 2; !names.add(unique); i++) unique = name + "_" + i;
        addRounded(unique, false);
        return unique;
    }

    private void addRounded(String name, boolean normalized) {
        if (!ChannelValues.isHeld(channel) && !ChannelValues.isFloat32(channel)) rounded.add(channel.name());
        addAs(name, type(), normalized, ChannelValues.exact(channel), "");
    }

    private void addAs(
            String name, ComponentType type, boolean normalized, VertexAttribute.Values values, String more) {
        ObjectNode jsm = JsonNodeFactory.instance.objectNode();
        jsm.put(GltfExtras.NAME, channel.name());
        jsm.put(GltfExtras.SEMANTIC, channel.semantic().name());
        if (!rounded.contains(channel.name()))
            jsm.put(GltfExtras.TYPE, channel.type().name());
        jsm.put(GltfExtras.ORDER, order);
        if (!more.isEmpty()) jsm.put(more, true);
        ObjectNode extras = JsonNodeFactory.instance.objectNode();
        extras.set(GltfExtras.JSM, jsm);
        int n = channel.components();
        attributes.add(new VertexAttribute(name, n, type, normalized, values, allOwn ? null : extras, extras));
    }

    private void addCopy(String name, ComponentType type, VertexAttribute.Values values, String of) {
        ObjectNode extras = JsonNodeFactory.instance.objectNode();
        extras.putObject(GltfExtras.JSM).put(GltfExtras.COPY_OF, of);
        boolean normalized = type != ComponentType.FLOAT;
        attributes.add(new VertexAttribute(name, channel.components(), type, normalized, values, extras, null));
    }

    /** The first name of a set that no other channel has. */
    private String free(String set) {
        int n = 0;
        while (!names.add(set + n)) n++;
        return set + n;
    }

    /** The component type that holds the numbers of the channel, or most of them. */
    private ComponentType type() {
        return switch (channel.type()) {
            case UINT8 -> ComponentType.UNSIGNED_BYTE;
            case INT8 -> ComponentType.BYTE;
            case UINT16 -> ComponentType.UNSIGNED_SHORT;
            case INT16 -> ComponentType.SHORT;
            default -> ComponentType.FLOAT;
        };
    }
}
