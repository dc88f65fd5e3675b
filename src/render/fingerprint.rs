/// A number that tells contents apart, by the 32-bit FNV-1a hash of Fowler, Noll and Vo (RFC 9923).
pub(super) fn fingerprint(bytes: &[u8]) -> u32 {
    bytes.iter().fold(0x811c_9dc5, |hash: u32, byte| (hash ^ u32::from(*byte)).wrapping_mul(0x0100_0193))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_the_published_ones() {
        assert_eq!([&b""[..], b"a", b"foobar"].map(fingerprint), [0x811c_9dc5, 0xe40c_292c, 0xbf9c_f968]);
    }
}
